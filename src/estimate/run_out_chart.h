#pragma once

#include <string>
#include <vector>

#include "core/input_error.h"
#include "estimate/chart_points.h"
#include "estimate/polynomial_fit.h"

namespace runout {

/// What a chart says of one question. Run-outs are L/sqrt(S).
struct Estimate {
    double run_out = 0;
    double half_width_68 = 0;  ///< the run-out of a run would lie within with a probability of 68 %
    double half_width_95 = 0;
    /// The question lies between the few values that the runs have of these: the interval is then that of
    /// leaving out all runs with one of the values.
    std::vector<ChartVariable> between_values_of;
    ChartPlace place{};  ///< that was asked, what had not to be given filled in
    ChartPoint nearest;  ///< run, in variables scaled by their spread
};

/// The surface L/sqrt(S) = f(...) through stored runs: a polynomial of the variables that vary in them. A
/// chart of some hundred runs takes some milliseconds (docs/estimate.md), so it is made anew for each
/// question and nothing of it is stored.
class RunOutChart {
  public:
    /// Runs that a chart needs at least: with fewer nothing can be said of 95 %.
    static constexpr std::size_t fewest_runs = 20;

    /// `origin` names the database in messages. Throws InputError: too few runs.
    RunOutChart(ChartPoints points, std::string origin);

    /// Throws InputError: a variable that varies is not given, one that does not vary is asked for at another
    /// value, the place lies outside the range of a variable or outside the convex hull of the runs, or
    /// between two values with nothing to tell what lies between them.
    [[nodiscard]] Estimate estimate(const ChartQuestion& question) const;

    [[nodiscard]] const ChartPoints& points() const { return points_; }
    [[nodiscard]] const PolynomialFit& surface() const { return surface_; }
    [[nodiscard]] std::vector<ChartVariable> varying() const;
    [[nodiscard]] bool varies(ChartVariable variable) const;
    [[nodiscard]] double lowest(ChartVariable variable) const { return axis(variable).low; }
    [[nodiscard]] double highest(ChartVariable variable) const { return axis(variable).high; }
    /// Root mean square of the errors of leaving one run out.
    [[nodiscard]] double left_out_error() const;

  private:
    struct Axis {
        double low = 0, high = 0;
        std::vector<double> values;  ///< distinct ones, rising; empty where they are too many for a grid
        int highest_power = 0;
    };

    [[nodiscard]] Axis axis_of(ChartVariable variable) const;
    [[nodiscard]] const Axis& axis(ChartVariable variable) const {
        return axes_[static_cast<std::size_t>(variable)];
    }
    [[nodiscard]] Eigen::VectorXd scaled(const ChartPlace& place) const;
    [[nodiscard]] SurfaceData surface_data() const;
    [[nodiscard]] std::vector<int> highest_powers() const;

    [[nodiscard]] ChartPlace checked_place(const ChartPlace& asked) const;
    void check_inside(const ChartPlace& place) const;
    [[nodiscard]] const ChartPoint& nearest_point(const ChartPlace& place) const;
    [[nodiscard]] std::vector<ChartVariable> between_values(const ChartPlace& place) const;
    [[nodiscard]] std::vector<double> even_errors() const;
    [[nodiscard]] std::vector<double> errors_without_values(ChartVariable variable) const;
    [[nodiscard]] InputPlace input_place(ChartVariable variable, double value) const;

    ChartPoints points_;
    std::string origin_;
    std::array<Axis, chart_variables> axes_;
    SurfaceData data_;
    PolynomialFit surface_;
};

/// Half-width that a share of the absolute errors does not pass, by split-conformal rank: the
/// ceil(share (n + 1))-th of n, which holds a further error of their kind with that probability. Infinite
/// where they are too few.
double error_quantile(std::vector<double> errors, double share);

}  // namespace runout
