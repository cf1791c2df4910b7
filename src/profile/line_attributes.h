#pragma once

#include "profile/profile.h"

namespace runout {

/// Options that the user left open, from the attributes of the line: toe_chainage_m and crest_chainage_m, or
/// what a shapefile leaves of them, toe_chaina and crest_chai. Numbers, or text that holds one ("36.0", "36
/// m"); an empty one says nothing. Throws InputError that names feature and attribute: anything else.
ProfileOptions with_attributes(ProfileOptions options, const SectionLine& line, const std::string& file);

}  // namespace runout
