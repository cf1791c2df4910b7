#pragma once

#include "engine/problem.h"
#include "scene/scene.h"

namespace runout {

/// The mass of a source, as the engine fills it with particles.
Mass mass_of(const Source& source);

/// dl, m: as given, or from the resolution and the area of the source.
double spacing_of(const Scene& scene);

/// The scene in the words of the engine: the only way from one to the other.
Problem make_problem(const Scene& scene);

}  // namespace runout
