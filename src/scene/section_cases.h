#pragma once

#include <optional>
#include <vector>

#include "profile/profile.h"
#include "scene/case_spec.h"

namespace runout {

/// One of the sections that a case asks for.
struct SectionCase {
    CaseSpec spec;
    std::optional<SectionFeature> line;  ///< none where the section comes from no map
};

/// One case for each section: a layer with many lines, of which none is chosen, is as many sections, each
/// named after the case and its line; one that is no section has its refusal. A single line gives its name to
/// a run that has none. Throws InputError as section_features, and when keys do not go together.
std::vector<SectionCase> section_cases(const CaseSpec& spec);

}  // namespace runout
