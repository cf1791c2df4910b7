#pragma once

#include "engine/pairs/particle_system.h"
#include "engine/watch/work_ledger.h"

namespace runout {

/// Moves particles a little from where it is crowded to where it is not (particle shifting, Lind et al.
/// 2012). Without it, particles under tension draw together in clumps (the tensile instability of SPH), and
/// the soil tears where it should hold. Only particles inside the body are shifted, and only by a part of the
/// way they went in the step, so that soil at rest stays where it is. The change of potential energy is
/// booked as numerical.
void shift_crowded(ParticleSystem& particles, const Discretisation& discretisation, double gravity, double dt,
                   WorkLedger& ledger);

}  // namespace runout
