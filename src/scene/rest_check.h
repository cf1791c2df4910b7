#pragma once

#include <functional>
#include <string_view>

#include "core/input_error.h"
#include "scene/scene.h"

namespace runout {

/// Where a key of the case was given.
using PlaceOfKey = std::function<InputPlace(std::string_view key)>;

/// Throws InputError where friction is too little to end the motion within any section and no time limit ends
/// it; cohesion ends it too. Sliding on level ground a mass that fell by H goes H / strength. The key that is
/// to blame is named: the soil's own friction, the water, or the friction of a part of the bed on which the
/// mass could lie, which is less steep than the soil's friction angle and at least sqrt(S) long.
void check_comes_to_rest(const Scene& scene, const PlaceOfKey& place);

}  // namespace runout
