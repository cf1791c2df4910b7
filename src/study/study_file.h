#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "core/input_error.h"

namespace runout {

/// How a value is spread. Quantities as in a case file (angles in degrees).
struct Distribution {
    enum class Shape { normal, lognormal, triangular, uniform };
    Shape shape = Shape::normal;
    double mean = 0, deviation = 0;  ///< normal and lognormal: of the quantity itself, not of its logarithm
    double mode = 0;                 ///< triangular
    double low = 0,
           high = 0;  ///< triangular and uniform: ends; normal and lognormal: cut off there (infinite: not)
};

/// A key of a case that a study varies.
struct Factor {
    std::string key;
    std::variant<std::vector<std::string>, Distribution> values;  ///< a list, or what samples are drawn from
    InputPlace place;                                             ///< where the study says so

    [[nodiscard]] bool is_sampled() const { return std::holds_alternative<Distribution>(values); }
};

/// Rank correlation of two sampled factors.
struct Correlation {
    std::size_t first = 0, second = 0;  ///< places among the factors
    double rank = 0;                    ///< between -1 and 1
};

/// Which combinations a study asks for.
enum class StudyDesign {
    full,           ///< each combination of the lists, with each sample
    one_at_a_time,  ///< the first of each list and the median of each distribution, and each factor alone
                    ///< varied
};

/// Many scenarios of one case.
struct Study {
    std::string file;
    std::string text;  ///< of the file, as it stood
    std::string name;
    std::string case_file;  ///< what is not varied: a case or a bare section
    StudyDesign design = StudyDesign::full;
    int samples = 0;  ///< drawn by Latin hypercube; 0 when nothing is sampled
    std::uint64_t seed = 1;
    std::vector<Factor> factors;
    std::vector<Correlation> correlations;
};

/// Reads a study (TOML; docs/sweeps.md). Files in it are relative to its folder. Throws InputError with the
/// line: unreadable file, unknown key or distribution, nothing to vary, a list without values, a range that
/// leads nowhere, a distribution without spread, samples without a distribution or the reverse, a correlation
/// of what is not sampled.
Study read_study(const std::string& path);

}  // namespace runout
