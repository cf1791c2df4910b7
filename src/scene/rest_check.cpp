#include "scene/rest_check.h"

#include <algorithm>
#include <cmath>

namespace runout {
namespace {

constexpr double least_strength = 0.01;  // a hundred times the fall: 0.57 deg

}  // namespace

void check_comes_to_rest(const Material& material, const Effects& effects, const RunSettings& run,
                         const InputPlace& place) {
    double strength = std::sin(material.friction_angle);
    if (effects.base_friction) strength = std::min(strength, std::tan(effects.base_friction->angle));
    if (strength >= least_strength || run.time_limit > 0) return;
    throw InputError(place, "leaves nothing that would bring the mass to rest",
                     "give 0.58 deg or more, or run.time_limit_s as well, and the run ends there");
}

}  // namespace runout
