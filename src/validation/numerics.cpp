#include <fmt/format.h>

#include <cmath>

#include "validation/numerics_checks.h"
#include "validation/suite_cases.h"

namespace runout {
namespace numerics {

double Refinement::order() const {
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const Vec2& e : errors) {
        x += std::log(e.x());
        y += std::log(e.y());
        xx += std::log(e.x()) * std::log(e.x());
        xy += std::log(e.x()) * std::log(e.y());
    }
    const auto count = static_cast<double>(errors.size());
    return (count * xy - x * y) / (count * xx - x * x);
}

ValidationEntry exact(std::string quantity, const Comparison& comparison, std::string resolution,
                      std::string remark) {
    ValidationEntry entry;
    entry.quantity = std::move(quantity);
    entry.held_to = "exact";
    entry.reference = comparison.reference;
    entry.computed = comparison.computed;
    entry.kind = comparison.kind;
    entry.accepted = comparison.accepted;
    entry.resolution = std::move(resolution);
    entry.remark = std::move(remark);
    return entry;
}

ValidationEntry error_entry(std::string quantity, double computed, double accepted, std::string resolution,
                            std::string remark) {
    return exact(std::move(quantity), {ValidationEntry::none, computed, DeviationKind::at_most, accepted},
                 std::move(resolution), std::move(remark));
}

void add_errors(CaseReport& report, const Refinement& refinement, const std::string& remark) {
    for (const Vec2& e : refinement.errors) {
        const std::string resolution = fmt::format("L/dl = {:.0f}", 1 / e.x());
        report.entries.push_back(error_entry(refinement.label + ", relative L2 error, " + resolution, e.y(),
                                             ValidationEntry::none, resolution, remark));
    }
}

void add_order(CaseReport& report, const Refinement& refinement, double theory, double accepted,
               const std::string& remark) {
    const double coarse = refinement.errors.front().x();
    const double fine = refinement.errors.back().x();
    report.entries.push_back(exact(refinement.label + ", observed order",
                                   {theory, refinement.order(), DeviationKind::absolute, accepted},
                                   fmt::format("L/dl = {:.0f} to {:.0f}", 1 / coarse, 1 / fine), remark));
    add_errors(report, refinement);
}

Figure order_figure(const std::string& name, const std::string& title, const std::vector<Refinement>& all) {
    Figure figure;
    figure.name = name;
    figure.title = title;
    figure.x_label = "dl / L";
    figure.y_label = "log10 of the relative error";
    figure.logarithmic_x = true;
    for (const Refinement& refinement : all) {
        Curve curve;
        curve.style = Curve::Style::line;
        curve.label = fmt::format("{}: order {:.2f}", refinement.label, refinement.order());
        for (const Vec2& e : refinement.errors) curve.points.emplace_back(e.x(), std::log10(e.y()));
        figure.curves.push_back(curve);
    }
    return figure;
}

}  // namespace numerics

namespace {

std::vector<PlannedRun> plan_nothing(bool) {
    return {};
}

/// Computed with the engine's parts here and now: there is no scene to it that a run could store.
CaseReport evaluate(const CaseRuns&, const std::string&, bool quick) {
    CaseReport report;
    report.name = "numerics";
    report.title = "Numerical method against exact solutions";
    numerics::check_kernel(report);
    numerics::check_gradients(report, quick);
    numerics::check_pressure(report, quick);
    numerics::check_drop(report, quick);
    numerics::check_vortex(report, quick);
    numerics::check_shear(report);
    report.remarks.emplace_back(
        "An order is the slope of the logarithm of the error over that of the spacing at h = 1.3 dl, by "
        "least squares. Errors without a band are reported.");
    return report;
}

}  // namespace

ValidationCase numerics_case() {
    return {"numerics", plan_nothing, evaluate};
}

}  // namespace runout
