#pragma once

#include <string>

namespace runout {

/// A place where the passing debris is measured.
struct Gauge {
    std::string name{};
    double x = 0;  ///< m, local frame
};

}  // namespace runout
