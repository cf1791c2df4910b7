#pragma once

#include <array>

namespace runout {

/// What must hold in every step of every run, whatever the scene. A reading is a pure number that may not
/// exceed its limit.
enum class Invariant {
    particles,    ///< particles lost or doubled: the mass is exact
    penetration,  ///< depth of a particle behind the bed line, in spacings
    speed,        ///< greatest |v| / sqrt(2 g H), H the height of the soil at release above the lowest bed;
                  ///< what shaking supplied adds to g H
    energy_rise,  ///< rise of the mechanical energy over the least so far / (M g H)
    energy_balance,  ///< |energy lost - work of friction, of the projection and of the bed line| / (M g H)
    density,         ///< excess of the densest particle over rho_0
    volume,          ///< area lost by the mean excess of density over the least so far / area
    pressure,        ///< tension beyond what the soil bears / (rho g H)
    residual,        ///< steps in a row whose pressure solve missed its tolerance / 20; ends as not_converged
    bed_guard,       ///< particles driven into the bed / particles, mean of all steps
    time_step,       ///< floor of the step / step
    count            ///< how many there are
};

/// The word stored and printed: "penetration", "energy_rise", ...
const char* to_string(Invariant invariant);
/// The limit and what it is a limit of, one line for people.
const char* meaning_of(Invariant invariant);

/// How near a run came to violating an invariant, and where.
struct InvariantReading {
    double worst = 0;  ///< greatest reading so far; NaN where one was no number
    double limit = 0;  ///< that it may not exceed
    double time = 0;   ///< s, of the worst
    double x = 0;      ///< of the particle to blame, or of the fastest where no single one is, m
};
/// One for each Invariant, in its order.
using InvariantReadings = std::array<InvariantReading, static_cast<int>(Invariant::count)>;

}  // namespace runout
