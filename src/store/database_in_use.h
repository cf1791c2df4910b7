#pragma once

#include "core/input_error.h"

namespace runout {

/// Another program holds the database for longer than we wait.
class DatabaseInUse : public InputError {
  public:
    using InputError::InputError;
};

}  // namespace runout
