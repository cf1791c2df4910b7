#pragma once

#include <array>
#include <vector>

#include "core/geometry.h"
#include "engine/particles/soil.h"

namespace runout {

/// Judges whether the mass has come to rest: for some time no particle has got away from its place, and the
/// mean motion since then has next to no energy.
/// - What counts as motion: a single grain that is still on its way, and a pile that is about to give way.
///   The pile at first moves by less than grains that tremble.
/// - What does not: trembling, which leads nowhere. On a bed of next to no friction lone grains may rock for
///   ever from one particle of the bed to the next.
/// So the further particles get from their places, the longer they are watched.
class RestWatch {
  public:
    /// `length`: sqrt(S), m; `spacing`: of the particles, m.
    RestWatch(double gravity, double length, double spacing);

    /// To be called at the start and after soil has been added: the soil as it is now, not yet moving.
    void start(const Soil& soil, double time);
    void observe(const Soil& soil, double time);

    [[nodiscard]] bool at_rest() const { return progress() >= 1.0; }
    /// Last instant at which the mass was still moving, s; single grains do not count.
    [[nodiscard]] double motion_ended() const;
    /// How much of the time at rest that it takes has passed: 0 while the mass moves, 1 at rest.
    [[nodiscard]] double progress() const;

  private:
    /// Positions at an instant, by id.
    struct Mark {
        double time = 0;  ///< s
        std::vector<Vec2> place;

        void take(const Soil& soil, double now);
    };
    /// Since when every particle has kept its place to within `way`. It is rest if that lasts for `enough`.
    struct Stay {
        double way = 0;     ///< m
        double enough = 0;  ///< s
        Mark since;
        double rested = 0;  ///< s
    };

    void close_window(const Soil& soil, double time);
    [[nodiscard]] double energy_since(const Mark& mark, const Soil& soil, double time) const;
    [[nodiscard]] double furthest_since(const Mark& mark, const Soil& soil) const;

    double rest_energy_;  ///< of the mean motion, J/kg
    double window_;       ///< s
    Mark opened_;         ///< when the window opened
    std::array<Stay, 3> stays_;
    double last_motion_ = 0;
};

}  // namespace runout
