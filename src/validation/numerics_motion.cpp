// Soil without strength in motion: a drop that is drawn out, and a vortex.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "validation/numerics_checks.h"
#include "validation/numerics_fluid.h"

namespace runout::numerics {
namespace {

constexpr double pi = std::numbers::pi;

// --- elliptical drop -------------------------------------------------------------------------------------

/// Disc of radius 1 on a lattice that is turned by `turn`.
std::vector<Vec2> disc(double dl, double turn) {
    const Vec2 along{std::cos(turn), std::sin(turn)};
    const Vec2 across{-along.y(), along.x()};
    std::vector<Vec2> points;
    for (const Vec2& p : lattice(dl, {-1.0 - dl, -1.0 - dl}, {1.0 + dl, 1.0 + dl})) {
        if (p.norm() < 1.0) points.push_back(p.x() * along + p.y() * across);
    }
    return points;
}

/// Semi-axis a over its start, and rate A: u = -A x, v = A y.
struct Ellipse {
    double a = 1, rate = -1;

    [[nodiscard]] Ellipse change() const {
        const double q = std::pow(a, 4);
        return {-a * rate, rate * rate * (q - 1) / (q + 1)};
    }
    [[nodiscard]] Ellipse ahead(const Ellipse& slope, double dt) const {
        return {a + dt * slope.a, rate + dt * slope.rate};
    }
    /// Runge-Kutta of fourth order.
    void step(double dt) {
        const Ellipse k1 = change();
        const Ellipse k2 = ahead(k1, 0.5 * dt).change();
        const Ellipse k3 = ahead(k2, 0.5 * dt).change();
        const Ellipse k4 = ahead(k3, dt).change();
        a += dt / 6 * (k1.a + 2 * k2.a + 2 * k3.a + k4.a);
        rate += dt / 6 * (k1.rate + 2 * k2.rate + 2 * k3.rate + k4.rate);
    }
};

/// Semi-axes of the ellipse with the particles' second moments.
Vec2 semi_axes(const Soil& soil) {
    Vec2 squares{0, 0};
    for (int i = 0; i < soil.count; ++i) squares += Vec2{soil.x[i] * soil.x[i], soil.y[i] * soil.y[i]};
    return {2 * std::sqrt(squares.x() / soil.count), 2 * std::sqrt(squares.y() / soil.count)};
}

/// A drop until its long axis should have doubled.
struct DropRun {
    int cells = 0;
    std::vector<Vec2> a, b, exact_a, exact_b;  ///< over time
    double energy = 0;                         ///< at the end, over the start
};

DropRun run_drop(int cells, double turn) {
    Fluid fluid(1.0 / cells, disc(1.0 / cells, turn), no_bed(), 1.0, 1.0, 0.0);
    Soil& soil = fluid.cloud.soil;
    for (int i = 0; i < soil.count; ++i) {  // drawn out along x
        soil.vx[i] = soil.x[i];
        soil.vy[i] = -soil.y[i];
    }
    const double radius = std::sqrt(soil.count * fluid.cloud.d.volume() / pi);
    const double start_energy = fluid.kinetic_energy();
    DropRun run{cells, {}, {}, {}, {}, 0};
    Ellipse ellipse;
    const auto keep = [&] {
        const Vec2 axes = semi_axes(soil) / radius;
        run.a.emplace_back(fluid.time(), axes.x());
        run.b.emplace_back(fluid.time(), axes.y());
        run.exact_a.emplace_back(fluid.time(), ellipse.a);
        run.exact_b.emplace_back(fluid.time(), 1 / ellipse.a);
    };
    keep();
    while (ellipse.a < 2.0) {
        const double before = fluid.time();
        fluid.step(before + 1.0);
        ellipse.step(fluid.time() - before);
        if (fluid.time() > 0.05 * static_cast<double>(run.a.size())) keep();
    }
    keep();
    run.energy = fluid.kinetic_energy() / start_energy;
    return run;
}

void add_drop(CaseReport& report, const DropRun& run, const std::string& lattice_name) {
    const auto relative = DeviationKind::relative;
    const std::string name = "drop, " + lattice_name + fmt::format(", R/dl = {}: ", run.cells);
    const std::string resolution = fmt::format("R/dl = {}, h = 1.3 dl", run.cells);
    const double a = run.a.back().y(), b = run.b.back().y();
    report.entries.push_back(
        exact(name + "long semi-axis / R", {run.exact_a.back().y(), a, relative, 0.015}, resolution));
    report.entries.push_back(
        exact(name + "short semi-axis / R", {run.exact_b.back().y(), b, relative, 0.03}, resolution));
    report.entries.push_back(
        exact(name + "area from the semi-axes, over the start", {1.0, a * b, relative, 0.03}, resolution));
    report.entries.push_back(
        exact(name + "kinetic energy, over the start", {1.0, run.energy, relative, 0.01}, resolution));
}

Curve curve_of(std::string label, Curve::Style style, const std::vector<Vec2>& points) {
    Curve curve;
    curve.label = std::move(label);
    curve.style = style;
    curve.points = points;
    return curve;
}

// --- vortex ----------------------------------------------------------------------------------------------

// One cell of the Taylor-Green vortex in the square from 1/4 to 3/4: speed 1 on its rim.
constexpr double half_turn = 0.5;  // of the core, whose angular velocity is 2 pi
constexpr double gravity = 10.0;

Vec2 taylor_green(double x, double y) {
    return {-std::cos(2 * pi * x) * std::sin(2 * pi * y), std::sin(2 * pi * x) * std::cos(2 * pi * y)};
}

struct VortexRun {
    double decay = 0;  ///< of kinetic energy
    double error = 0;  ///< of velocity, L2, relative
};

VortexRun run_vortex(int cells) {
    const double dl = 0.5 / cells;
    const BedLine box({{0.25, 1.25}, {0.25, 0.25}, {0.75, 0.25}, {0.75, 1.25}});
    Fluid fluid(dl, lattice(dl, {0.25, 0.25}, {0.75, 0.75}), box, 1.0, 0.5, gravity);
    Soil& soil = fluid.cloud.soil;
    for (int i = 0; i < soil.count; ++i) {
        const Vec2 v = taylor_green(soil.x[i], soil.y[i]);
        soil.vx[i] = v.x();
        soil.vy[i] = v.y();
        soil.pressure[i] = density * gravity * (0.75 - soil.y[i]);
    }
    const double start_energy = fluid.kinetic_energy();
    while (fluid.time() < half_turn) fluid.step(half_turn);
    double error2 = 0.0, size2 = 0.0;
    for (int i = 0; i < soil.count; ++i) {
        const Vec2 wanted = taylor_green(soil.x[i], soil.y[i]);
        error2 += (Vec2{soil.vx[i], soil.vy[i]} - wanted).squaredNorm();
        size2 += wanted.squaredNorm();
    }
    return {1.0 - fluid.kinetic_energy() / start_energy, std::sqrt(error2 / size2)};
}

}  // namespace

void check_drop(CaseReport& report, bool quick) {
    const std::vector<int> resolutions = quick ? std::vector<int>{16, 24} : std::vector<int>{16, 32, 48};
    std::vector<DropRun> runs;
    for (const int cells : resolutions) runs.push_back(run_drop(cells, 0.25 * pi));
    const DropRun aligned = run_drop(resolutions[1], 0.0);
    for (const DropRun& run : runs) add_drop(report, run, "lattice at 45 deg");
    add_drop(report, aligned, "lattice along the axes");

    Figure figure;
    figure.name = "drop";
    figure.title = "Semi-axes of the elliptical drop";
    figure.x_label = "t A0";
    figure.y_label = "semi-axis / R";
    const DropRun& finest = runs.back();
    const std::string turned = fmt::format("lattice at 45 deg, R/dl = {}, ", finest.cells);
    const std::string along = fmt::format("lattice along the axes, R/dl = {}, ", aligned.cells);
    figure.curves = {curve_of("exact, long", Curve::Style::line, finest.exact_a),
                     curve_of("exact, short", Curve::Style::line, finest.exact_b),
                     curve_of(turned + "long", Curve::Style::markers, finest.a),
                     curve_of(turned + "short", Curve::Style::markers, finest.b),
                     curve_of(along + "long", Curve::Style::dashed, aligned.a),
                     curve_of(along + "short", Curve::Style::dashed, aligned.b)};
    report.figures.push_back(figure);
}

void check_vortex(CaseReport& report, bool quick) {
    Refinement decay{"vortex, loss of kinetic energy in half a turn", {}};
    Refinement error{"vortex, velocity after half a turn", {}};
    double reynolds = 0.0;
    for (const int cells : quick ? std::vector<int>{16, 24, 32} : std::vector<int>{16, 24, 32, 48}) {
        const VortexRun run = run_vortex(cells);
        decay.errors.emplace_back(1.0 / cells, run.decay);
        error.errors.emplace_back(1.0 / cells, run.error);
        reynolds = -16 * pi * pi * half_turn / std::log(1 - run.decay);
    }
    add_order(report, decay, 1.0, 0.3, "exact: no loss at all");
    add_errors(report, error);
    report.entries.push_back(error_entry("vortex, Reynolds number of a fluid with the same loss", reynolds,
                                         ValidationEntry::none,
                                         fmt::format("L/dl = {:.0f}", 1 / decay.errors.back().x())));
    report.figures.push_back(order_figure("vortex", "What half a turn takes from a vortex", {decay, error}));
}

}  // namespace runout::numerics
