#pragma once

#include <array>
#include <vector>

#include "core/geometry.h"
#include "engine/particles/soil.h"

namespace runout {

/// Judges whether the mass has come to rest: for some time no particle has got away from its place, and the
/// mean motion since then has next to no energy. A single grain that is still on its way counts, and so does
/// a pile that is about to give way, which at first moves by less than grains that tremble. Trembling, which
/// leads nowhere, does not count: lone grains may rock to and fro for ever, by as much as from one particle
/// of a bed of next to no friction to the next. The further particles get from their places, the longer they
/// are watched.
class RestWatch {
  public:
    /// `length`: sqrt(S), m; `spacing`: of the particles, m.
    RestWatch(double gravity, double length, double spacing);

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
    /// That every particle has kept its place to within `way` since an instant; rest if it lasts for
    /// `enough`.
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
