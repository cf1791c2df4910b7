#pragma once

#include <string>
#include <vector>

#include "validation/entry.h"

namespace runout::numerics {

/// Errors of one method at falling spacings.
struct Refinement {
    std::string label;
    std::vector<Vec2> errors;  ///< spacing over the size of the domain, relative error

    /// Slope of log(error) over log(spacing), by least squares.
    [[nodiscard]] double order() const;
};

/// Adds the error at each spacing, which is not judged.
void add_errors(CaseReport& report, const Refinement& refinement, const std::string& remark = {});
/// Adds the observed order, held to the theoretical one to within `accepted`, and the errors.
void add_order(CaseReport& report, const Refinement& refinement, double theory, double accepted,
               const std::string& remark = {});

/// A computed number beside the one it is held to.
struct Comparison {
    double reference;
    double computed;
    DeviationKind kind;
    double accepted;  ///< greatest |deviation|; NaN: reported
};

/// Entry that is held to an exact number.
ValidationEntry exact(std::string quantity, const Comparison& comparison, std::string resolution,
                      std::string remark = {});
/// Entry for an error that must not exceed `accepted`; NaN: reported.
ValidationEntry error_entry(std::string quantity, double computed, double accepted, std::string resolution,
                            std::string remark = {});

/// A curve per refinement, log10 of the error over the spacing.
Figure order_figure(const std::string& name, const std::string& title, const std::vector<Refinement>& all);

// Each adds its entries and figures. `quick`: fewer and coarser resolutions.
void check_kernel(CaseReport& report);
void check_gradients(CaseReport& report, bool quick);
void check_pressure(CaseReport& report, bool quick);
void check_drop(CaseReport& report, bool quick);
void check_vortex(CaseReport& report, bool quick);
void check_shear(CaseReport& report);

}  // namespace runout::numerics
