#pragma once

#include <vector>

#include "core/geometry.h"
#include "engine/soil.h"

namespace runout {

/// Judges whether the mass has come to rest, by how far the particles get in windows of time, so that the
/// trembling of lone grains, which leads nowhere, does not count; a grain that is still on its way does.
class RestWatch {
  public:
    /// `length`: sqrt(S), m. `grain_way`: that no particle makes in a window at rest, m; infinite where
    /// single particles do not count.
    RestWatch(double gravity, double length, double grain_way);

    /// Soil as it is now, not yet moving; also after more has been added.
    void start(const Soil& soil, double time);
    void observe(const Soil& soil, double time);

    [[nodiscard]] bool at_rest() const;
    /// Last instant at which the mass was still moving, whatever single grains did, s.
    [[nodiscard]] double motion_ended() const { return last_motion_; }
    /// Share of the windows at rest that it takes, 0 while the mass moves.
    [[nodiscard]] double progress() const;

  private:
    void close_window(const Soil& soil, double time);

    double rest_energy_;      ///< of the mean motion, J/kg
    double window_;           ///< s
    double grain_way_;        ///< m
    std::vector<Vec2> mark_;  ///< positions when the window opened, by id
    double mark_time_ = 0;
    double last_motion_ = 0;
    int resting_windows_ = 0;
};

}  // namespace runout
