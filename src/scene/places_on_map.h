#pragma once

#include <span>
#include <vector>

#include "scene/case_spec.h"
#include "scene/scene.h"

namespace runout {

/// The features of [places] near the section line, as places by their distance from the toe; equal names,
/// also those of `named`, get the feature id. None without [places]. What lies wholly beyond the end of the
/// section or uphill of `source_end`, the x of the lower end of the source, is left out; what reaches over
/// them is cut there. That, and that nothing is near, is told in the doubts of the profile. Throws
/// InputError: a section on no map, and as features_near.
std::vector<Place> places_on_map(const CaseSpec& spec, Site& site, double source_end,
                                 std::span<const Place> named);

}  // namespace runout
