#pragma once

#include "scene/case_spec.h"

namespace runout {

/// Throws InputError when keys of the case exclude each other, lack each other, or do not apply to what was
/// chosen: a value that would have no effect is a mistake, not a detail.
void check_keys_go_together(const CaseSpec& spec);

}  // namespace runout
