#pragma once

#include <limits>
#include <string>
#include <vector>

#include "core/figure.h"

namespace runout {

/// How far a computed number is from the one it is held against.
enum class DeviationKind {
    relative,  ///< computed / reference - 1
    absolute,  ///< computed - reference, in the unit of the quantity
    at_most,   ///< computed itself, which must not exceed `accepted`; there is no reference
};

/// One line of the validation table. NaN: does not apply.
struct ValidationEntry {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    std::string quantity{};  ///< with its unit: "front, m"
    std::string held_to{};   ///< origin of the reference: "Lube et al. 2005", "exact"
    double reference = none;
    double computed = none;
    DeviationKind kind = DeviationKind::relative;
    double accepted = none;    ///< greatest |deviation|; NaN: reported without judgement
    double scatter = none;     ///< standard deviation over jittered lattices, unit of `computed`
    double error = none;       ///< numerical error bar of `computed`, same unit
    std::string resolution{};  ///< "sqrt(S)/dl = 30", "dl = 2 mm, 5,000 particles"
    std::string remark{};      ///< what a reader must know; empty mostly
};

double deviation(const ValidationEntry& entry);
/// False also when the computed number does not exist. True where nothing is asked.
bool within_band(const ValidationEntry& entry);

/// What validation says of one case.
struct CaseReport {
    std::string name{};   ///< folder under cases/
    std::string title{};  ///< one line
    std::vector<ValidationEntry> entries{};
    std::vector<Figure> figures{};
    std::vector<std::string> remarks{};  ///< sentences below the table, such as a fit with its confidence
};

}  // namespace runout
