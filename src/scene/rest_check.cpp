#include "scene/rest_check.h"

#include <algorithm>
#include <cmath>

namespace runout {
namespace {

constexpr double enough_strength = 0.01;  // a hundred times the fall: 0.57 deg

}  // namespace

double least_strength(const Material& material, const Effects& effects) {
    double strength = std::sin(material.friction_angle);
    if (!effects.base_friction) return strength;
    const auto weaken = [&](double angle) {
        if (!std::isnan(angle)) strength = std::min(strength, std::tan(angle));
    };
    weaken(effects.base_friction->angle);
    for (const FrictionRange& range : effects.base_friction->ranges) weaken(range.angle);
    return strength;
}

void check_comes_to_rest(const Material& material, const Effects& effects, const RunSettings& run,
                         const InputPlace& place) {
    const bool cohesive = effects.cohesion && effects.cohesion->strength > 0;
    if (least_strength(material, effects) >= enough_strength || cohesive || run.time_limit > 0) return;
    throw InputError(place, "leaves nothing that would bring the mass to rest",
                     "give 0.58 deg or more, or run.time_limit_s as well, and the run ends there");
}

}  // namespace runout
