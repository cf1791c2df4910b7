// Kernel and gradients against integrals and derivatives.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/pairs/operators.h"
#include "validation/numerics_checks.h"
#include "validation/numerics_fluid.h"

namespace runout::numerics {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double jitter_share = 0.2;  // of a spacing each way: about as uneven as soil in motion
constexpr double margin = 0.15;       // rows nearer than this to the edge of the unit square are left out

std::vector<int> resolutions(bool quick) {
    return quick ? std::vector<int>{50, 100, 200} : std::vector<int>{50, 100, 200, 400};
}

Cloud unit_square(int cells, double jitter_of) {
    std::vector<Vec2> points = lattice(1.0 / cells, {0, 0}, {1, 1});
    jitter(points, 1.0 / cells, jitter_of, 1);
    return {1.0 / cells, points, no_bed()};
}

bool is_inside(const Soil& soil, int i) {
    const double low = std::min(soil.x[i], soil.y[i]);
    return low > margin && std::max(soil.x[i], soil.y[i]) < 1.0 - margin;
}

/// Calls f(i, renormalised gradient) inside, for the velocity (u, v) as functions of x, y.
template <class U, class V, class Function>
void renormalised(const Cloud& cloud, const U& u, const V& v, const Function& f) {
    std::vector<FloatPair> velocity(cloud.neighbours.nodes);
    for (int i = 0; i < cloud.soil.count; ++i) {
        velocity[i] = {static_cast<float>(u(cloud.soil.x[i], cloud.soil.y[i])),
                       static_cast<float>(v(cloud.soil.x[i], cloud.soil.y[i]))};
    }
    for (const PairBlock& block : cloud.neighbours.blocks) {
        for_each_velocity_gradient(block, cloud.neighbours, velocity.data(),
                                   [&](int i, const VelocityGradient& plain) {
                                       if (is_inside(cloud.soil, i))
                                           f(i, plain.corrected(cloud.neighbours, i));
                                   });
    }
}

/// Greatest error of any component for v = (2x - 3y, 5x + y), over the greatest component.
double linear_error() {
    const Cloud cloud = unit_square(50, jitter_share);
    double worst = 0.0;
    renormalised(
        cloud, [](double x, double y) { return 2 * x - 3 * y; }, [](double x, double y) { return 5 * x + y; },
        [&](int, const VelocityGradient& g) {
            worst = std::max(
                {worst, std::abs(g.xx - 2), std::abs(g.xy + 3), std::abs(g.yx - 5), std::abs(g.yy - 1)});
        });
    return worst / 5.0;
}

/// L2 error of the renormalised gradient of u = sin(pi x) cos(pi y).
double renormalised_error(int cells, double jitter_of) {
    const Cloud cloud = unit_square(cells, jitter_of);
    double error2 = 0.0, size2 = 0.0;
    renormalised(
        cloud, [](double x, double y) { return std::sin(pi * x) * std::cos(pi * y); },
        [](double, double) { return 0.0; },
        [&](int i, const VelocityGradient& g) {
            const double x = cloud.soil.x[i], y = cloud.soil.y[i];
            const Vec2 wanted{pi * std::cos(pi * x) * std::cos(pi * y),
                              -pi * std::sin(pi * x) * std::sin(pi * y)};
            error2 += (Vec2{g.xx, g.xy} - wanted).squaredNorm();
            size2 += wanted.squaredNorm();
        });
    return std::sqrt(error2 / size2);
}

/// L2 error of the plain pressure gradient of p = 2 + sin(pi x) cos(pi y), over `factor`.
double plain_error(int cells, double jitter_of, double factor) {
    const Cloud cloud = unit_square(cells, jitter_of);
    std::vector<double> p(cloud.neighbours.nodes, 0.0);
    for (int i = 0; i < cloud.soil.count; ++i)
        p[i] = 2.0 + std::sin(pi * cloud.soil.x[i]) * std::cos(pi * cloud.soil.y[i]);
    const NodeVectors gradient = cloud.pressure_gradient(p);
    double error2 = 0.0, size2 = 0.0;
    for (int i = 0; i < cloud.soil.count; ++i) {
        if (!is_inside(cloud.soil, i)) continue;
        const double x = cloud.soil.x[i], y = cloud.soil.y[i];
        const Vec2 wanted{pi * std::cos(pi * x) * std::cos(pi * y),
                          -pi * std::sin(pi * x) * std::sin(pi * y)};
        error2 += (Vec2{gradient.x[i], gradient.y[i]} / factor - wanted).squaredNorm();
        size2 += wanted.squaredNorm();
    }
    return std::sqrt(error2 / size2);
}

template <class Error>
Refinement refine(std::string label, bool quick, const Error& error) {
    Refinement refinement{std::move(label), {}};
    for (const int cells : resolutions(quick)) refinement.errors.emplace_back(1.0 / cells, error(cells));
    return refinement;
}

/// Midpoint rule over the support of a kernel with h = 1 of f(r), rings of 2 pi r dr.
template <class Function>
double integral(const Function& f) {
    const int steps = 20000;
    const double dr = 2.0 / steps;
    double sum = 0.0;
    for (int k = 0; k < steps; ++k) sum += 2.0 * pi * (k + 0.5) * dr * f((k + 0.5) * dr) * dr;
    return sum;
}

}  // namespace

double lattice_moment(const Discretisation& d) {
    const WendlandKernel kernel(d.smoothing_length);
    double sum = 0.0;
    for (int i = -3; i <= 3; ++i) {
        for (int j = -3; j <= 3; ++j)
            sum -= i * i * d.volume() * d.volume() * kernel.slope(d.spacing * std::hypot(i, j));
    }
    return sum;
}

void check_kernel(CaseReport& report) {
    const WendlandKernel kernel(1.0);
    const Discretisation d = make_discretisation(0.01, 1.3, density);
    const auto absolute = DeviationKind::absolute;
    report.entries.push_back(exact("kernel, integral over the plane", 1.0,
                                   integral([&](double r) { return kernel.value(r); }), absolute, 1e-7,
                                   "midpoint rule, 20,000 rings"));
    // The mean of x^2 over a ring is r^2 / 2.
    report.entries.push_back(exact("kernel gradient, first moment: integral of -x dW/dx", 1.0,
                                   integral([&](double r) { return -0.5 * r * r * kernel.slope(r); }),
                                   absolute, 1e-7, "midpoint rule, 20,000 rings"));
    report.entries.push_back(exact("kernel, sum over the square lattice", 1.0105, d.lattice_sum * d.volume(),
                                   absolute, 5e-5, "h = 1.3 dl",
                                   "reference: docs/engine.md; densities are scaled by it"));
    report.entries.push_back(exact("kernel gradient, first moment over the square lattice", 1.0,
                                   lattice_moment(d), absolute, ValidationEntry::none, "h = 1.3 dl",
                                   "what the plain gradient is too large by at any spacing"));
}

void check_gradients(CaseReport& report, bool quick) {
    const double moment = lattice_moment(make_discretisation(0.01, 1.3, density));
    report.entries.push_back(
        error_entry("renormalised gradient of a linear velocity, greatest relative error", linear_error(),
                    1e-4, "L/dl = 50", "rounding of single precision; particles 0.2 dl off the lattice"));
    const Refinement smooth = refine("renormalised gradient, lattice", quick,
                                     [](int cells) { return renormalised_error(cells, 0.0); });
    const Refinement uneven = refine("renormalised gradient, uneven particles", quick,
                                     [](int cells) { return renormalised_error(cells, jitter_share); });
    const Refinement plain = refine("plain pressure gradient, lattice", quick,
                                    [&](int cells) { return plain_error(cells, 0.0, moment); });
    const Refinement noisy = refine("plain pressure gradient, uneven particles", quick,
                                    [&](int cells) { return plain_error(cells, jitter_share, 1.0); });
    add_order(report, smooth, 2.0, 0.15);
    add_order(report, uneven, 1.0, 0.15);
    add_order(report, plain, 2.0, 0.15, "against the gradient times its first moment over the lattice");
    add_order(report, noisy, -1.0, 0.15,
              "the adjoint of the divergence conserves momentum, but pushes uneven particles apart");
    report.figures.push_back(
        order_figure("gradients", "Error of the gradients inside a square", {smooth, uneven, plain, noisy}));
}

}  // namespace runout::numerics
