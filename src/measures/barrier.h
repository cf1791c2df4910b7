#pragma once

#include "engine/simulation.h"
#include "measures/measures.h"
#include "scene/scene.h"

namespace runout {

/// Reads off the load of a barrier in every step; stores it at equal steps of simulated time.
class BarrierRecorder {
  public:
    /// `interval`: between stored rows, s; also the time over which the stored force is averaged.
    BarrierRecorder(const Scene& scene, double interval, double front_thickness);

    void sample(const Simulation& simulation, bool always = false);
    [[nodiscard]] BarrierRecord record() const { return record_; }

  private:
    void read_approach(const StateView& state);

    Barrier barrier_;
    double foot_y_, back_x_;
    double density_;
    double front_thickness_;
    double interval_;
    double due_ = 0;
    double last_time_ = 0;
    Vec2 last_impulse_{0, 0};
    BarrierRecord record_;
};

}  // namespace runout
