#pragma once

#include <string>

#include "core/input_error.h"

namespace runout {

/// How exact a run-out is asked to be: the numerical error that L_inf may have, with 95 % confidence.
struct AccuracyTarget {
    double share = 0;   ///< of the run-out; 0: `metres` is given
    double metres = 0;  ///< 0: `share` is given

    /// The error allowed for a run-out, m. A mass that hardly passes the toe is judged by its own size, since
    /// a share of nothing is nothing: `root_area` is sqrt(S).
    [[nodiscard]] double metres_of(double run_out, double root_area) const;
    /// "5 %", "0.25 m"
    [[nodiscard]] std::string text() const;
};

/// Reads "5%" or "0.25 m". Throws InputError, which names `place`.
AccuracyTarget accuracy_target(const std::string& text, const InputPlace& place);

}  // namespace runout
