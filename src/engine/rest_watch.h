#pragma once

#include <vector>

#include "core/geometry.h"
#include "engine/soil.h"

namespace runout {

/// Judges whether the mass has come to rest: for some time no particle has got away from its place, and the
/// mean motion since then has next to no energy. Trembling, which leads nowhere, does not count; a single
/// grain that is still on its way does.
class RestWatch {
  public:
    /// `length`: sqrt(S), m. `grain_way`: how far from its place a particle may get, m.
    RestWatch(double gravity, double length, double grain_way);

    /// Soil as it is now, not yet moving; also after more has been added.
    void start(const Soil& soil, double time);
    void observe(const Soil& soil, double time);

    [[nodiscard]] bool at_rest() const { return progress() >= 1.0; }
    /// Last instant at which the mass was still moving, whatever single grains did, s.
    [[nodiscard]] double motion_ended() const;
    /// Share of the time at rest that it takes, 0 while the mass moves.
    [[nodiscard]] double progress() const;

  private:
    /// Positions at an instant, by id.
    struct Mark {
        double time = 0;  ///< s
        std::vector<Vec2> place;

        void take(const Soil& soil, double now);
    };

    void close_window(const Soil& soil, double time);
    [[nodiscard]] double energy_since(const Mark& mark, const Soil& soil, double time) const;
    [[nodiscard]] double furthest_since(const Mark& mark, const Soil& soil) const;

    double rest_energy_;  ///< of the mean motion, J/kg
    double window_;       ///< s
    double grain_way_;    ///< m
    Mark opened_;         ///< when the window opened
    Mark settled_;        ///< since when every particle has kept its place
    double last_motion_ = 0;
    double rested_ = 0;  ///< s
};

}  // namespace runout
