// The pressure equation against a manufactured solution, and what its projection leaves of a velocity.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "validation/numerics_checks.h"
#include "validation/numerics_fluid.h"

namespace runout::numerics {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double tolerance = 1e-8;
constexpr int passes = 60;
// The solver imposes rho g dl / 4 on boundary particles that have one or two soil neighbours, here where the
// surface meets the walls. There is no weight in these fields, so it must be next to nothing.
constexpr double no_gravity = 1e-9;

/// Unit box with open top, filled to the brim.
Cloud full_box(int cells) {
    return {1.0 / cells, lattice(1.0 / cells, {0, 0}, {1, 1}), BedLine({{0, 2}, {0, 0}, {1, 0}, {1, 2}})};
}

// phi = (1 + cos(2 pi x) / 2) cos(pi y / 2): never negative, zero at the surface y = 1, and with no slope
// across the walls.
double potential(double x, double y) {
    return (1 + 0.5 * std::cos(2 * pi * x)) * std::cos(0.5 * pi * y);
}
Vec2 slope(double x, double y) {
    return {-pi * std::sin(2 * pi * x) * std::cos(0.5 * pi * y),
            -0.5 * pi * (1 + 0.5 * std::cos(2 * pi * x)) * std::sin(0.5 * pi * y)};
}

// Stream function sin(2 pi x) sin(pi y / 2): free of divergence, no flow through the walls.
Vec2 solenoidal(double x, double y) {
    return {0.5 * pi * std::sin(2 * pi * x) * std::cos(0.5 * pi * y),
            -2 * pi * std::cos(2 * pi * x) * std::sin(0.5 * pi * y)};
}

/// `share` of the solenoidal field plus grad phi, by node.
NodeVectors field_on(const Cloud& cloud, double share) {
    const auto nodes = static_cast<std::size_t>(cloud.neighbours.nodes);
    NodeVectors field{std::vector(nodes, 0.0), std::vector(nodes, 0.0)};
    for (int i = 0; i < cloud.soil.count; ++i) {
        const double x = cloud.soil.x[i], y = cloud.soil.y[i];
        const Vec2 v = share * solenoidal(x, y) + slope(x, y);
        field.x[i] = v.x();
        field.y[i] = v.y();
    }
    return field;
}

/// The lattice's divergence of the gradient over its Laplacian of eq. 5, for long waves: what is not 1 is due
/// to eta.
double laplacian_ratio(const Discretisation& d) {
    const WendlandKernel kernel(d.smoothing_length);
    double sum = 0.0;
    for (int i = -3; i <= 3; ++i) {
        for (int j = -3; j <= 3; ++j) {
            const double r2 = d.volume() * (i * i + j * j);
            sum += 0.5 * density * d.stiffness(kernel.slope(std::sqrt(r2)), r2) * i * i * d.volume();
        }
    }
    return lattice_moment(d) / sum;
}

/// With dt = rho the velocity v* = grad phi asks for the pressure phi. L2 error of p over `ratio`.
double manufactured_error(int cells, double ratio) {
    Cloud cloud = full_box(cells);
    PressureSolver solver(cloud.d, no_gravity, 1.0, tolerance);
    NodeVectors gradient;
    solver.solve(cloud, field_on(cloud, 0.0), {density, 0.0, false, 1.0}, gradient);
    double error2 = 0.0, size2 = 0.0;
    for (int i = 0; i < cloud.soil.count; ++i) {
        const double wanted = potential(cloud.soil.x[i], cloud.soil.y[i]);
        error2 += std::pow(cloud.soil.pressure[i] / ratio - wanted, 2);
        size2 += wanted * wanted;
    }
    return std::sqrt(error2 / size2);
}

/// Solves `count` times with full memory, so that the projection becomes exact, and returns what is left of
/// v + grad phi less v, over v.
double projection_error(int cells, int count) {
    Cloud cloud = full_box(cells);
    PressureSolver solver(cloud.d, no_gravity, 1.0, tolerance);
    const NodeVectors field = field_on(cloud, 1.0);
    NodeVectors gradient;
    for (int k = 0; k < count; ++k) solver.solve(cloud, field, {density, 1.0, false, 1.0}, gradient);
    double error2 = 0.0, size2 = 0.0;
    for (int i = 0; i < cloud.soil.count; ++i) {
        const Vec2 wanted = solenoidal(cloud.soil.x[i], cloud.soil.y[i]);
        error2 += (Vec2{field.x[i] - gradient.x[i], field.y[i] - gradient.y[i]} - wanted).squaredNorm();
        size2 += wanted.squaredNorm();
    }
    return std::sqrt(error2 / size2);
}

}  // namespace

void check_pressure(CaseReport& report, bool quick) {
    const double ratio = laplacian_ratio(make_discretisation(0.01, 1.3, density));
    report.entries.push_back(exact("divergence of the gradient over the Laplacian of eq. 5, long waves", 1.0,
                                   ratio, DeviationKind::absolute, 0.02, "h = 1.3 dl",
                                   "eta = 0.1 h; the incremental projection works it off"));
    const std::vector<int> resolutions =
        quick ? std::vector<int>{20, 40, 80} : std::vector<int>{20, 40, 80, 160};
    Refinement pressure{"pressure, manufactured solution", {}};
    Refinement once{"projection of v + grad phi, one pass", {}};
    Refinement often{fmt::format("projection of v + grad phi, {} passes", passes), {}};
    for (const int cells : resolutions) {
        pressure.errors.emplace_back(1.0 / cells, manufactured_error(cells, ratio));
        once.errors.emplace_back(1.0 / cells, projection_error(cells, 1));
        if (cells <= 80) often.errors.emplace_back(1.0 / cells, projection_error(cells, passes));
    }
    add_order(report, pressure, 1.0, 0.25, "against phi times the ratio of the operators");
    add_errors(report, once, "what the next steps of the incremental projection work off");
    add_order(report, often, 1.0, 0.25);
    report.figures.push_back(order_figure("pressure", "Error of the pressure equation in a box with open top",
                                          {pressure, once, often}));
}

}  // namespace runout::numerics
