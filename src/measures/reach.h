#pragma once

#include "engine/state_view.h"
#include "measures/thickness.h"

namespace runout {

/// How far the debris comes: the front and what is beyond it, over time. Local x; `ThicknessField::nowhere`
/// where nothing is thick enough.
class ReachRecorder {
  public:
    ReachRecorder(const FrontRule& rule, const StateView& start);

    void look(const StateView& state);

    /// The soil of the last look.
    [[nodiscard]] const ThicknessField& soil() const { return soil_; }
    [[nodiscard]] double front() const { return front_; }
    [[nodiscard]] double farthest_front() const { return farthest_front_; }
    /// Greatest speed towards the run-out of the soil in the window at the front, m/s.
    [[nodiscard]] double peak_front_speed() const { return peak_front_speed_; }
    /// Greatest x of any grain.
    [[nodiscard]] double farthest_soil() const { return farthest_soil_; }
    /// Greatest speed of a grain that was beyond the front, m/s.
    [[nodiscard]] double speed_beyond_front() const { return speed_beyond_front_; }

  private:
    ThicknessField soil_;
    double front_ = ThicknessField::nowhere;
    double farthest_front_ = ThicknessField::nowhere;
    double farthest_soil_ = ThicknessField::nowhere;
    double peak_front_speed_ = 0;
    double speed_beyond_front_ = 0;
};

}  // namespace runout
