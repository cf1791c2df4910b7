#pragma once

#include "scene/case_spec.h"

namespace runout {

/// Throws InputError for a length that makes sense only beside the size of the mass, sqrt(area), and is out
/// of all proportion to it: the run would settle, or never end, and its numbers would mean nothing. `area` in
/// m2.
void check_lengths(const CaseSpec& spec, double area);

}  // namespace runout
