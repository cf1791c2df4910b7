#pragma once

#include <vector>

#include "engine/particles/soil.h"
#include "scene/effects.h"

namespace runout {

/// Particles that fill a mass which is let go later. Where soil that came down before lies in its place, the
/// whole mass is let go from above it: it is raised by spacings until no two particles are nearer than 0.7 of
/// one.
std::vector<Vec2> place_mass(const LaterMass& mass, const Soil& soil, double spacing, double smoothing_ratio);

}  // namespace runout
