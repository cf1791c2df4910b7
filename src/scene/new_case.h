#pragma once

#include <string>

#include "scene/case_spec.h"

namespace runout {

/// A case to begin with.
struct NewCase {
    std::string text;               ///< of the case file
    SourceType source_type{};       ///< of its source
    bool example_friction = false;  ///< the friction angle is an example, since none was given
};

/// Writes the case that `spec` is: what was given as keys that hold, what was found (toe, crest, sizes of the
/// source) as keys in comments, each key with what it means. Where nothing is said of the source, the first
/// that fits: as drawn, type B, a slip line. Paths are written relative to `folder`. Throws InputError as
/// make_site, and when no source fits.
NewCase new_case(const CaseSpec& spec, const std::string& folder);

}  // namespace runout
