#pragma once

#include "engine/bed_line.h"
#include "engine/soil.h"

namespace runout {

/// A grain is lone where the soil around it weighs less in its kernel than one grain at this distance, in
/// smoothing lengths: two spacings.
constexpr double touching_lengths = 2.0 / 1.3;

/// A grain that no other touches, as the bed sees it: a point mass that lies half a spacing off the bed line.
/// A kernel needs neighbours; a grain without any trembles on its cushion of wall particles, and creeps where
/// it should stand.
struct LoneGrain {
    Vec2 velocity{0, 0};   ///< m/s
    double clearance = 0;  ///< from where it lies to the bed, m; negative: pressed in
    Vec2 normal{0, 1};     ///< of the bed, unit
    double strength = 0;   ///< shear over normal traction on the bed
};

/// Its velocity after a step of dt (s) in which the body accelerates it by `gain` (m/s): an inelastic
/// landing, and Coulomb friction by the impulse of the bed, so that one layer slides and stands as a slab
/// does.
Vec2 velocity_on_bed(const LoneGrain& grain, const Vec2& gain, double dt);

}  // namespace runout
