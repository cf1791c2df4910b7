#pragma once

#include <string>

#include "store/store.h"

namespace runout {

/// What the farthest front says of a place, beside the numerical error of the run-out.
struct PlaceDoubt {
    bool reached = false;
    double beyond_front_m = 0;  ///< of the place beyond the farthest front; negative: behind it
    double error_m = 0;         ///< of the run-out, 95 %; NaN: not known

    /// The front could as well be on the other side of the place: nobody should take it for safe, nor the
    /// other way round.
    [[nodiscard]] bool within_error() const;
    /// "not reached, but 0.1 m beyond the front is within its error of +-0.5 m"
    [[nodiscard]] std::string sentence() const;
    /// "not reached, within error", for a cell of a table.
    [[nodiscard]] std::string words() const;
};

PlaceDoubt place_doubt(const StoredRun& run, const PlaceRecord& place);
PlaceDoubt place_doubt(const ReachRow& row);

}  // namespace runout
