#pragma once

#include <vector>

#include "scene/case_spec.h"
#include "scene/scene.h"

namespace runout {

/// The effects of the case on this site: chainages become positions on the profile, files are read. Throws
/// InputError for what does not fit the site or contradicts itself.
Effects place_effects(const CaseSpec& spec, const Site& site);

/// The places of the case, named and placed. Throws InputError when one has no chainage or is not on the
/// section.
std::vector<Place> located_places(const CaseSpec& spec, Site& site);

}  // namespace runout
