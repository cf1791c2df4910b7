#pragma once

#include "engine/pairs/particle_system.h"
#include "engine/watch/work_ledger.h"

namespace runout {

/// Particles under tension draw together in clumps (the tensile instability of SPH), and the soil tears where
/// it should hold. They are moved a little from where it is crowded to where it is not, in the inside of the
/// body only (particle shifting, Lind et al. 2012), and only on their way, so that soil at rest stays where
/// it is. What they are lifted by is booked as a loss of the numerics.
void shift_crowded(ParticleSystem& particles, const Discretisation& discretisation, double gravity, double dt,
                   WorkLedger& ledger);

}  // namespace runout
