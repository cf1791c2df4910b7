#pragma once

#include <string>

#include "store/store.h"

namespace runout {

/// The study of that name, or else of that number. `database` names the file in the message. Throws
/// InputError when there is none.
StoredStudy chosen_study(const Store& store, const std::string& database, const std::string& name_or_id);

}  // namespace runout
