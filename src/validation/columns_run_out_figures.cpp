#include <fmt/format.h>

#include <cmath>

#include "validation/columns_laws.h"
#include "validation/columns_run_out.h"
#include "validation/data_file.h"
#include "validation/profile_misfit.h"

namespace runout::run_out_columns {
namespace {

/// L_inf/sqrt(S) of a law for L_inf/L_0, drawn over the aspects shown.
template <class Law>
std::vector<Vec2> curve_of(const Law& law, double from, double to) {
    constexpr int steps = 60;
    std::vector<Vec2> points;
    for (int k = 0; k <= steps; ++k) {
        const double a = from * std::pow(to / from, static_cast<double>(k) / steps);
        points.emplace_back(a, law(a));
    }
    return points;
}

/// From L_inf/L_0 to L_inf/sqrt(S) = L_inf / (L_0 sqrt(a)).
double over_root_area(double front, double aspect) {
    return front / std::sqrt(aspect);
}

std::vector<Vec2> computed_points(const Spread& spread) {
    std::vector<Vec2> points;
    for (std::size_t k = 0; k < spread.aspects.size(); ++k) {
        if (std::isnan(spread.front[k].mean)) continue;
        points.emplace_back(spread.aspects[k], over_root_area(spread.front[k].mean, spread.aspects[k]));
    }
    return points;
}

void add_fit_curve(Figure& figure, const Spread& spread) {
    const std::vector<Vec2> points = eq10_points(spread);
    if (points.size() < 3) return;
    const LineFit fit = fit_line(points);
    const double from = 1.0 / (points.front().x() * points.front().x());
    figure.curves.push_back(
        {fmt::format("eq. 10, phi {:.0f}", spread.friction_angle), Curve::Style::line,
         curve_of([&](double a) { return fit.intercept + fit.slope / std::sqrt(a); }, from, 20.0)});
}

Figure run_out_figure(const std::vector<Spread>& spreads, const std::string& folder) {
    Figure figure{"run-out", "Run-out against aspect ratio", "a = H0/L0", "L_inf/sqrt(S)", {}, false, true};
    for (const Spread& spread : spreads) {
        figure.curves.push_back({fmt::format("phi {:.0f}", spread.friction_angle), Curve::Style::markers,
                                 computed_points(spread)});
        add_fit_curve(figure, spread);
    }
    const auto lube = [](double a) { return over_root_area(lube_front(a), a); };
    const auto lajeunesse = [](double a) { return over_root_area(1.0 + lajeunesse_run_out(a), a); };
    figure.curves.push_back({"law of Lube et al. 2005", Curve::Style::dashed, curve_of(lube, 0.3, 20.0)});
    figure.curves.push_back(
        {"law of Lajeunesse et al. 2005", Curve::Style::dashed, curve_of(lajeunesse, 0.3, 20.0)});
    std::vector<Vec2> measured;
    for (const Vec2& p : read_points(folder + "/lajeunesse2005_runout_digitised.csv"))
        if (p.x() >= 0.3) measured.emplace_back(p.x(), over_root_area(1.0 + p.y(), p.x()));
    figure.curves.push_back({"Lajeunesse et al. 2005, measured", Curve::Style::markers, measured});
    return figure;
}

Figure height_figure(const Spread& spread, const std::string& folder) {
    Figure figure{"height", "Final height against aspect ratio", "a = H0/L0", "H_inf/L0", {}, false, true};
    std::vector<Vec2> computed;
    for (std::size_t k = 0; k < spread.aspects.size(); ++k)
        computed.emplace_back(spread.aspects[k], spread.height[k].mean);
    figure.curves.push_back({fmt::format("phi {:.0f}", spread.friction_angle), Curve::Style::line, computed});
    figure.curves.push_back({"Lajeunesse et al. 2005, measured", Curve::Style::markers,
                             read_points(folder + "/lajeunesse2005_height_digitised.csv")});
    return figure;
}

Figure profile_figure(const CaseRuns& runs, double friction_angle, const std::vector<double>& aspects) {
    Figure figure{"profiles",  fmt::format("Normalised deposits, phi {:.0f}", friction_angle),
                  "x/sqrt(S)", "y/sqrt(S)",
                  {},          true,
                  false};
    for (const double a : aspects) {
        if (a == 0.7 || a == 1.5 || a == 7.0 || a == 15.0) continue;  // a chart of all would be a thicket
        const std::string run = lattices_of(name_of(friction_angle, a)).front();
        const double spacing = runs.run(run).work.particle_spacing_m;
        std::vector<Vec2> surface = drawn_to_bed(deposit_surface(runs.deposit(run)), spacing);
        for (Vec2& p : surface) p /= root_area;
        figure.curves.push_back({fmt::format("a = {}", a), Curve::Style::line, surface});
    }
    return figure;
}

}  // namespace

void add_figures(CaseReport& report, const CaseRuns& runs, const std::vector<Spread>& spreads,
                 const std::string& folder) {
    report.figures.push_back(run_out_figure(spreads, folder));
    for (const Spread& spread : spreads) {
        if (spread.friction_angle == 27.0) report.figures.push_back(height_figure(spread, folder));
        if (spread.friction_angle == 37.0)
            report.figures.push_back(profile_figure(runs, spread.friction_angle, spread.aspects));
    }
}

}  // namespace runout::run_out_columns
