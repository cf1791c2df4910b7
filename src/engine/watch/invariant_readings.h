#pragma once

#include <array>

namespace runout {

/// What must hold in every step of every run, whatever the scene. A reading is a pure number that may not
/// exceed its limit.
enum class Invariant {
    particles,       ///< numbers lost or repeated: the mass is exact
    penetration,     ///< depth of a particle behind the bed line, in spacings
    speed,           ///< |v| / sqrt(2 g H), H the height of the source above the lowest bed; g H and what
                     ///< shaking supplied
    energy_rise,     ///< rise of the mechanical energy over the least so far / (M g H)
    energy_balance,  ///< |energy lost - work of friction, of the projection and of the bed line| / (M g H)
    density,         ///< excess of the densest particle over rho_0
    volume,          ///< area lost by the mean excess of density over the least so far / area
    pressure,        ///< tension beyond what the soil bears / (rho g H)
    residual,        ///< steps in a row whose pressure solve missed its tolerance / 20; ends as not_converged
    wall_guard,      ///< particles driven into the bed / particles, mean of all steps
    time_step,       ///< floor of the step / step
    count
};

/// The word stored and printed: "penetration", "energy_rise", ...
const char* to_string(Invariant invariant);
/// The limit and what it is a limit of, one line for people.
const char* meaning_of(Invariant invariant);

/// How near a run came to violating an invariant, and where.
struct InvariantReading {
    double worst = 0;
    double limit = 0;
    double time = 0;  ///< s, of the worst
    double x = 0;     ///< m, local frame: the particle to blame, or the fastest where no single one is
};
using InvariantReadings = std::array<InvariantReading, static_cast<int>(Invariant::count)>;

}  // namespace runout
