#pragma once

#include <string>
#include <vector>

#include "engine/simulation.h"
#include "measures/reach.h"
#include "scene/scene.h"

namespace runout {

/// Finds out when what still creeps can no longer matter, so that a run need not go on to its time limit.
///
/// Energy left, J/m: the kinetic energy of all soil, and what potential energy it would lose until the time
/// limit at the rate of the last window. Least lump that counts as the front: 16/15 of window times threshold
/// of the front rule (the kernel's peak is 15/16 over its window). Against the friction of the bed the energy
/// left can move that lump by
///
///   d = energy left / (rho g area of the lump (mu cos(beta) - sin(beta))),
///
/// mu and beta where the bed within a window of the front, and d beyond it, resists least. The creep is
/// negligible when d is less than `share` of the run-out (of sqrt(S) where that is more), and no more
/// potential energy was lost in the last window than in the one before: what truly slides gets faster. In
/// both windows the mass as a whole lay still (Simulation::motion_ended). A bed that the lump would slide on
/// by itself is never negligible. Not where water, shaking or later releases change the strength or the load
/// with time.
class CreepWatch {
  public:
    static constexpr double share = 0.005;
    static constexpr double window_time_scales = 20;  ///< of a window; Simulation::time_scale

    CreepWatch(const Scene& scene, const Simulation& simulation);

    /// To be called after each step.
    void look(const Simulation& simulation, const ReachRecorder& reach);

    [[nodiscard]] bool negligible() const { return negligible_; }
    /// What still crept, and what it could do; empty unless it is negligible.
    [[nodiscard]] const std::string& sentence() const { return sentence_; }

  private:
    [[nodiscard]] double resistance(const StateView& state, double from, double to) const;
    [[nodiscard]] double crept_share(const StateView& state) const;
    void open_window(const Simulation& simulation);
    void judge(const Simulation& simulation, double front);

    const Scene& scene_;
    bool watches_;
    double window_;  ///< s
    double opened_ = 0;
    double potential_ = 0;      ///< when the window opened, J/m
    double loss_before_ = 0;    ///< of potential energy in the window before, J/m
    std::vector<Vec2> places_;  ///< when the window opened, by id, m
    bool negligible_ = false;
    std::string sentence_;
};

}  // namespace runout
