#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry.h"
#include "engine/particles/cell_grid.h"
#include "engine/particles/kernel.h"
#include "engine/particles/soil.h"

namespace runout {

/// Puts soil to sleep that lies still under a load that does not change, far from all that moves, and wakes
/// it when that ends. What sleeps keeps its place, pressure and stress; friction and pressure are not solved
/// for it, and to its neighbours it is a rough bed.
///
/// Motion and load are judged over windows of time. Soil falls asleep after two quiet windows in which
/// nothing within one to two cells of 3 dl was restless; soil that starts to slide gets faster from window to
/// window and so is not taken for quiet. It wakes in the step in which anything within the same reach moves
/// or changes its load; the limits of waking are some times those of falling asleep, so that no soil does
/// both in turn.
class SleepWatch {
  public:
    /// `window`: s.
    SleepWatch(const Discretisation& discretisation, double gravity, double window, int threads = 1);

    /// All is awake from here on; also after particles have been added.
    void wake_all(const Soil& soil, double time);
    /// Particles have been added, which are awake.
    void append(const Soil& soil);
    /// Judges the soil as it is now. `density`: rho / rho_0.
    void observe(const Soil& soil, const std::vector<double>& density, double time);
    /// On return `resting` is 1 for each slice of the sorted soil whose particles all sleep, and the number
    /// of these particles is returned; empty and 0 if there are none. Soil that shares a slice with what
    /// moves moves with it.
    int find_resting(const Soil& soil, std::vector<char>& resting) const;
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
    /// What went on in a cell, summed over its particles.
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
