#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry.h"
#include "engine/particles/cell_grid.h"
#include "engine/particles/discretisation.h"
#include "engine/particles/soil.h"

namespace runout {

/// Decides which soil sleeps: soil that lies still under a load that does not change, far from all that
/// moves. What sleeps keeps its place, pressure and stress. Friction and pressure are not solved for it, and
/// to its neighbours it is a rough bed.
///
/// Motion and load are judged over windows of time. Soil falls asleep after two windows in which nothing
/// within one to two cells of 3 dl was restless. Soil that starts to slide gets faster from window to window,
/// and so is restless. Soil wakes in the step in which anything within the same reach moves or changes its
/// load. The limits for waking are higher than those for falling asleep, so that soil does not do both in
/// turn.
class SleepWatch {
  public:
    /// `window`: s.
    SleepWatch(const Discretisation& discretisation, double gravity, double window, int threads = 1);

    /// Wakes all soil, and knows all particles from here on.
    void wake_all(const Soil& soil, double time);
    /// Particles have been added. They are awake.
    void append(const Soil& soil);
    /// To be called after each step. `density`: rho / rho_0 per particle.
    void observe(const Soil& soil, const std::vector<double>& density, double time);
    /// On return `asleep` is 1 for each slice of the sorted soil whose particles all sleep; it is empty if
    /// there is no such slice. Returns how many particles these slices have. Sleeping soil in a slice with
    /// soil that is awake is treated as awake.
    int find_sleeping(const Soil& soil, std::vector<char>& asleep) const;
    /// rho / rho_0 that a particle fell asleep with.
    [[nodiscard]] double density(int id) const { return mark_[id].density; }

  private:
    /// A particle when the window opened, by id.
    struct Mark {
        Vec2 place{0, 0};
        double pressure = 0;
        double moved = 0;  ///< in the window before, m
        double density = 1;
        int quiet_windows = 0;
        bool asleep = false;
    };
    /// Motion in a cell, summed over its particles.
    struct Growth {
        double moved = 0;   ///< in this window, m
        double before = 0;  ///< in the window before, m
        int particles = 0;
    };

    void find_restless(const Soil& soil, double motion, double load);
    void find_growing(const Soil& soil);
    void spread(const Soil& soil);
    void close_window(const Soil& soil, const std::vector<double>& density, double time);
    void wake(const Soil& soil);

    int threads_;
    double spacing_;  ///< m
    double unit_;     ///< rho g dl, Pa
    double window_;   ///< s
    double opened_ = 0;
    int sleepers_ = 0;
    std::vector<Mark> mark_;
    std::vector<int> shares_;  ///< of the threads, see even_shares
    CellGrid grid_;
    std::vector<char> is_restless_;  ///< per particle
    std::vector<char> restless_;     ///< per cell: something in it is, until it has been spread
    std::vector<char> disturbed_;    ///< per cell: something in it or next to it is
    std::vector<Growth> growth_;     ///< per cell
};

}  // namespace runout
