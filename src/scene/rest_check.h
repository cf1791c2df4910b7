#pragma once

#include "core/input_error.h"
#include "scene/scene.h"

namespace runout {

/// What resists sliding on the bed where that is least, over the pressure: sin(phi), or tan(delta) of a
/// weaker base.
double least_strength(const Material& material, const Effects& effects);

/// Throws InputError, at `place`, where friction is too little to end the motion within any section and no
/// time limit ends it; cohesion ends it too. Sliding on level ground a mass that fell by H goes H / strength.
void check_comes_to_rest(const Material& material, const Effects& effects, const RunSettings& run,
                         const InputPlace& place);

}  // namespace runout
