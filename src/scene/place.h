#pragma once

#include <string>

namespace runout {

/// A place that the case asks about: what arrives there is answered in every output.
struct Place {
    std::string name{};
    double x = 0;        ///< of its near edge, m, local frame
    double width = 0;    ///< from there away from the cut, m; 0: a line
    std::string kind{};  ///< building, road, barrier line, ... as the case says it; empty: not said
};

}  // namespace runout
