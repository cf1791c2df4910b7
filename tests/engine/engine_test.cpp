// The engine's parts against exact values: kernel, bed line, wall, operators, packing, pressure equation.

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <span>

#include "engine/friction/friction.h"
#include "engine/pairs/operators.h"
#include "engine/pairs/packing.h"
#include "engine/pressure/pressure_solver.h"
#include "engine/simd/instruction_set.h"
#include "filled_box.h"
#include "scene/make_problem.h"
#include "scenes.h"

namespace runout {
namespace {

using namespace filled_box;

TEST(Kernel, IntegratesToOne) {
    const WendlandKernel kernel(1.0);
    double sum = 0.0;
    const double dr = 1e-4;
    for (double r = 0.5 * dr; r < 2.0; r += dr) sum += 2.0 * std::numbers::pi * r * kernel.value(r) * dr;
    EXPECT_NEAR(sum, 1.0, 1e-8);
    EXPECT_EQ(kernel.value(2.0), 0.0);
}

TEST(Kernel, SlopeIsItsDerivative) {
    const WendlandKernel kernel(0.7);
    for (const double r : {0.1, 0.5, 0.9, 1.3}) {
        const double numeric = (kernel.value(r + 1e-6) - kernel.value(r - 1e-6)) / 2e-6;
        EXPECT_NEAR(kernel.slope(r) * r, numeric, 1e-7);
    }
}

TEST(Kernel, LatticeSumAtTheDefaultSmoothingRatio) {
    const Discretisation d = make_discretisation(spacing, 1.3, density);
    EXPECT_NEAR(d.lattice_sum * d.volume(), 1.0105,
                5e-5);  // the quadrature error that densities are scaled by
}

TEST(BedLineTest, SignedDistanceAtSegmentsAndCorners) {
    const BedLine bed({{-1, 1}, {0, 0}, {2, 0}});
    EXPECT_NEAR(bed.nearest({1, 0.5}).distance, 0.5, 1e-15);
    EXPECT_NEAR(bed.nearest({1, -0.5}).distance, -0.5, 1e-15);
    EXPECT_NEAR(bed.nearest({-0.5, 1.5}).distance, std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(bed.nearest({-0.1, -1.0}).distance, -std::hypot(0.1, 1.0), 1e-12);
    EXPECT_NEAR(bed.elevation(-0.25), 0.25, 1e-15);
    EXPECT_EQ(BedLine({{0, 1}, {0, 0}, {1, 0}}).elevation(0.0), 1.0);
}

// Soil above the top of a wall that ends the section was taken for soil deep in the wall.
TEST(BedLineTest, BeyondAFreeEndThereIsNoBed) {
    const BedLine bed({{0, 1}, {0, 0}, {1, 0}});
    EXPECT_NEAR(bed.nearest({-0.01, 1.2}).distance, std::hypot(0.01, 0.2), 1e-15);
    EXPECT_NEAR(bed.nearest({1.2, -0.01}).distance, std::hypot(0.01, 0.2), 1e-15);
    EXPECT_NEAR(bed.nearest({-0.01, 0.9}).distance, -0.01, 1e-15);
    const BedLine square({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, true);
    EXPECT_NEAR(square.nearest({-0.1, -0.1}).distance, -std::hypot(0.1, 0.1), 1e-15);
}

TEST(WallTest, StandsHalfASpacingBehindTheLineAndFillsTheLattice) {
    const Filled f(20);
    for (int b = 0; b < f.wall.boundary_count; ++b) {
        const double outside = std::max({-f.wall.x[b], -f.wall.y[b], f.wall.x[b] - 20 * spacing});
        EXPECT_NEAR(outside, 0.5 * spacing, 1e-12);
    }
    for (int i = 0; i < f.soil.count; ++i) {
        if (f.soil.y[i] < 15 * spacing) {
            EXPECT_NEAR(f.neighbours.density[i], 1.0, 1e-6);  // sums of single precision
        }
    }
}

TEST(WallTest, EveryDummyHasItsNearestBoundaryParticle) {
    const Filled f(12);
    for (int q = f.wall.boundary_count; q < f.wall.size(); ++q) {
        const auto distance = [&](int b) {
            return std::hypot(f.wall.x[q] - f.wall.x[b], f.wall.y[q] - f.wall.y[b]);
        };
        double least = 1e300;
        for (int b = 0; b < f.wall.boundary_count; ++b) least = std::min(least, distance(b));
        EXPECT_NEAR(distance(f.wall.group[q]), least, 1e-12);
    }
}

TEST(Operators, CorrectedGradientIsExactForALinearField) {
    Filled f(15);
    // v = (2x - 3y, 5x + y) vanishes nowhere on the wall, so only rows away from it are looked at.
    std::vector<FloatPair> velocity(f.neighbours.nodes);
    for (int i = 0; i < f.soil.count; ++i) {
        velocity[i] = {static_cast<float>(2 * f.soil.x[i] - 3 * f.soil.y[i]),
                       static_cast<float>(5 * f.soil.x[i] + f.soil.y[i])};
    }
    int checked = 0;
    for (const PairBlock& block : f.neighbours.blocks) {
        for_each_velocity_gradient(block, f.neighbours, velocity.data(),
                                   [&](int i, const VelocityGradient& plain) {
                                       if (f.neighbours.nearest_boundary[i] >= 0) return;
                                       const VelocityGradient g = plain.corrected(f.neighbours, i);
                                       EXPECT_NEAR(g.xx, 2, 3e-5);
                                       EXPECT_NEAR(g.xy, -3, 3e-5);
                                       EXPECT_NEAR(g.yx, 5, 3e-5);
                                       EXPECT_NEAR(g.yy, 1, 3e-5);
                                       EXPECT_NEAR(g.spin(), 4, 3e-5);
                                       ++checked;
                                   });
    }
    EXPECT_GT(checked, 80);
}

TEST(Operators, PressureGradientIsMinusTheAdjointOfDivergence) {
    Filled f(12);
    std::vector<double> p(f.neighbours.nodes, 0.0);
    std::vector<FloatPair> v(f.neighbours.nodes);
    std::vector<double> gx(f.neighbours.nodes, 0.0);
    std::vector<double> gy(f.neighbours.nodes, 0.0);
    std::vector<double> divergence(f.neighbours.nodes, 0.0);
    for (int i = 0; i < f.neighbours.nodes; ++i) p[i] = std::sin(12.9898 * i);
    for (int i = 0; i < f.soil.count; ++i) {
        v[i] = {static_cast<float>(std::sin(78.233 * i)), static_cast<float>(std::cos(39.425 * i))};
    }
    for (const PairBlock& block : f.neighbours.blocks) {
        pair_kernels().pressure_gradient(pair_rows(block, f.neighbours), p.data(), gx.data(), gy.data());
        pair_kernels().velocity_divergence(pair_rows(block, f.neighbours), v.data(), divergence.data());
    }
    double left = 0.0;
    double right = 0.0;
    for (int i = 0; i < f.soil.count; ++i) {
        left += gx[i] * v[i].x + gy[i] * v[i].y;
        right += p[i] * divergence[i];
    }
    for (int a = 0; a < f.neighbours.active_count(); ++a) {
        for (int k = f.neighbours.boundary_start[a]; k < f.neighbours.boundary_start[a + 1]; ++k) {
            const BoundaryPair& pair = f.neighbours.boundary_pairs[k];
            right += p[f.neighbours.first_boundary_node + a] *
                     (v[pair.soil].x * pair.gx + v[pair.soil].y * pair.gy);
        }
    }
    EXPECT_NEAR(left, -right, 1e-6 * std::abs(left));
}

TEST(Operators, EveryInstructionSetGivesTheSameBits) {
    Filled f(12);
    std::vector<double> p(f.neighbours.nodes, 0.0);
    std::vector<FloatPair> v(f.neighbours.nodes);
    for (int i = 0; i < f.neighbours.nodes; ++i) {
        p[i] = std::sin(78.233 * i);
        v[i] = {static_cast<float>(p[i]), static_cast<float>(std::cos(39.425 * i))};
    }
    const std::vector<float> strength(f.neighbours.nodes, 0.3F);
    const auto all = [&](const PairKernels& kernels) {
        std::vector<double> results;
        std::vector<double> a(f.neighbours.nodes, 0.0);
        std::vector<double> b(f.neighbours.nodes, 0.0);
        std::vector<FloatPair> u(f.neighbours.nodes);
        VelocityGradients g{};
        const auto keep = [&](const auto& values) {
            results.insert(results.end(), values.begin(), values.end());
        };
        const auto keep_pairs = [&](const std::vector<FloatPair>& values) {
            for (const FloatPair& value : values) keep(std::initializer_list<double>{value.x, value.y});
        };
        for (const PairBlock& block : f.neighbours.blocks) {
            const PairRows rows = pair_rows(block, f.neighbours);
            kernels.stress_divergence(rows, v.data(), u.data());
            keep_pairs(u);
            kernels.pressure_gradient(rows, p.data(), a.data(), b.data());
            keep(a);
            keep(b);
            kernels.velocity_divergence(rows, v.data(), a.data());
            keep(a);
            kernels.pressure_product(rows, p.data(), p.data(), a.data());
            keep(a);
            kernels.velocity_gradient(rows, v.data(), g);
            for (const float* part : {g.xx, g.xy, g.yx, g.yy}) keep(std::span(part, rows.slices * lanes));
            std::vector<FloatPair> stress = v;
            StressRotation rotation;
            rotation.dt = 0.001F;
            rotation.stress = stress.data();
            StressUpdate update;
            for (int c = 0; c < 4; ++c)
                update.correction[c] = rotation.correction[c] = f.neighbours.correction[c].data();
            update.strength = strength.data();
            update.step = 0.001F;
            update.momentum = 0.4F;
            update.stress = stress.data();
            update.ahead = u.data();
            kernels.rotate_stress(rows, g, rotation);
            keep_pairs(stress);
            kernels.update_stress(rows, g, update);
            keep_pairs(stress);
            keep_pairs(u);
        }
        return results;
    };
    for (const InstructionSet set : instruction_sets) {
        if (machine_has(set)) {
            EXPECT_EQ(all(pair_kernels(set)), all(pair_kernels_baseline)) << to_string(set);
        }
    }
}

TEST(Operators, StressUpdateStaysInTheYieldCircle) {
    Filled f(12);
    std::vector<FloatPair> velocity(f.neighbours.nodes);
    for (int i = 0; i < f.neighbours.nodes; ++i) {
        const auto v = static_cast<float>(std::sin(78.233 * i));
        velocity[i] = {v, v};
    }
    const std::vector<float> strength(f.neighbours.nodes, 0.3F);
    std::vector<FloatPair> stress(f.neighbours.nodes);
    std::vector<FloatPair> ahead(f.neighbours.nodes, FloatPair{1.0F, -1.0F});
    StressUpdate update{{}, strength.data(), 0.001F, 0.0F, stress.data(), ahead.data()};
    for (int c = 0; c < 4; ++c) update.correction[c] = f.neighbours.correction[c].data();
    for (const PairBlock& block : f.neighbours.blocks) {
        VelocityGradients gradients;
        pair_kernels().velocity_gradient(pair_rows(block, f.neighbours), velocity.data(), gradients);
        pair_kernels().update_stress(pair_rows(block, f.neighbours), gradients, update);
    }
    int at_yield = 0;
    for (int i = 0; i < f.soil.count; ++i) {
        const float size = std::hypot(stress[i].x, stress[i].y);
        EXPECT_LE(size, 0.3F * (1 + 1e-6F));
        at_yield += size > 0.299F ? 1 : 0;
    }
    EXPECT_GT(at_yield, 100);
}

TEST(Operators, RotationKeepsTheSizeOfTheStressAndTurnsItByTwiceTheAngle) {
    Filled f(12);
    // v = (-y, x) turns by 1 rad/s; the wall does not, so only rows away from it are looked at.
    std::vector<FloatPair> velocity(f.neighbours.nodes);
    for (int i = 0; i < f.soil.count; ++i) {
        velocity[i] = {static_cast<float>(-f.soil.y[i]), static_cast<float>(f.soil.x[i])};
    }
    std::vector<FloatPair> stress(f.neighbours.nodes, FloatPair{3.0F, 0.0F});
    StressRotation rotation;
    for (int c = 0; c < 4; ++c) rotation.correction[c] = f.neighbours.correction[c].data();
    rotation.dt = 0.01F;
    rotation.stress = stress.data();
    for (const PairBlock& block : f.neighbours.blocks) {
        VelocityGradients gradients;
        pair_kernels().velocity_gradient(pair_rows(block, f.neighbours), velocity.data(), gradients);
        pair_kernels().rotate_stress(pair_rows(block, f.neighbours), gradients, rotation);
    }
    int checked = 0;
    for (int i = 0; i < f.soil.count; ++i) {
        if (f.neighbours.nearest_boundary[i] >= 0) continue;
        EXPECT_NEAR(std::hypot(stress[i].x, stress[i].y), 3.0, 1e-6);
        EXPECT_NEAR(std::atan2(stress[i].y, stress[i].x), 0.02, 1e-6);
        ++checked;
    }
    EXPECT_GT(checked, 30);
}

TEST(Operators, InternalForcesAddUpToNothing) {
    // A block in the air: no wall, so no momentum from anywhere.
    Discretisation d = make_discretisation(spacing, 1.3, density);
    Soil soil = lattice(11, 11);
    const Wall wall = make_wall(BedLine({{-1, -1}, {1, -1}}), d);
    NeighbourSearch search(d, 1);
    Neighbours n;
    search.sort(soil);
    search.find(soil, wall, n);
    std::vector<FloatPair> stress(n.nodes);
    std::vector<FloatPair> force(n.nodes);
    for (int i = 0; i < soil.count; ++i) {
        stress[i] = {std::sin(3.0F * static_cast<float>(i)), std::cos(7.0F * static_cast<float>(i))};
    }
    for (const PairBlock& block : n.blocks) {
        pair_kernels().stress_divergence(pair_rows(block, n), stress.data(), force.data());
    }
    double largest = 0.0;
    double sum_x = 0.0;
    double sum_y = 0.0;
    for (int i = 0; i < soil.count; ++i) {
        largest = std::max(largest, std::abs(static_cast<double>(force[i].x)));
        sum_x += force[i].x;
        sum_y += force[i].y;
    }
    EXPECT_NEAR(sum_x, 0.0, 1e-4 * largest);
    EXPECT_NEAR(sum_y, 0.0, 1e-4 * largest);
}

TEST(PressureEquation, WeightOfAFilledBoxIsHydrostatic) {
    Filled f(20);
    PressureSolver solver(f.d, 9.81, 20 * spacing, 1e-6);
    const double dt = 1e-3;
    const NodeVectors velocity = even_velocity(f, {0.0, -9.81 * dt});
    NodeVectors gradient;
    // Repeated with full memory the projection becomes exact: nothing is left of the velocity.
    for (int pass = 0; pass < 60; ++pass) {
        EXPECT_TRUE(solver.solve(f, velocity, {dt, 1.0, false}, gradient).converged);
    }
    // What balances the weight is the plain gradient, which is too small on a lattice by its first moment.
    const WendlandKernel kernel(f.d.smoothing_length);
    double moment = 0.0;
    for (int i = -3; i <= 3; ++i) {
        for (int j = -3; j <= 3; ++j)
            moment -= f.d.volume() * kernel.slope(spacing * std::hypot(i, j)) * std::pow(i * spacing, 2);
    }
    EXPECT_NEAR(moment, 0.974, 1e-3);
    const double full = density * 9.81 * 20 * spacing / moment;
    for (int i = 0; i < f.soil.count; ++i) {
        EXPECT_NEAR(f.soil.pressure[i], full * (1.0 - f.soil.y[i] / (20 * spacing)), 0.01 * full);
    }
}

TEST(PressureEquation, IterationsDoNotGrowWithTheNumberOfParticles) {
    const auto iterations = [](int cells) {
        Filled f(cells);
        PressureSolver solver(f.d, 9.81, cells * spacing, 1e-3);
        NodeVectors gradient;
        return solver.solve(f, even_velocity(f, {0.0, -9.81e-3}), {1e-3, 0.0, false}, gradient).iterations;
    };
    EXPECT_LE(iterations(20), 25);
    EXPECT_LE(iterations(100), 25);
}

TEST(PackingTest, RectangleIsFilledExactly) {
    const Scene scene = scenes::aluminium_column(21.9, 0.002);
    const Packing packing = pack_mass(mass_of(scene.source), 0.002, 1.3);
    EXPECT_EQ(packing.points.size(), 5000U);
    EXPECT_NEAR(packing.spacing, 0.002, 1e-15);
    EXPECT_NEAR(std::ranges::min(packing.points, {}, [](const Vec2& p) { return p.x(); }).x(), 0.001, 1e-12);
    EXPECT_NEAR(std::ranges::max(packing.points, {}, [](const Vec2& p) { return p.y(); }).y(), 0.099, 1e-12);
}

TEST(PackingTest, MassOfATriangleIsExactAndNobodyIsSqueezed) {
    const Scene scene = scenes::heap(25.0, 0.1, 30.0, 0.003);
    const Packing packing = pack_mass(mass_of(scene.source), 0.003, 1.3);
    EXPECT_NEAR(packing.spacing * packing.spacing * static_cast<double>(packing.points.size()),
                scene.source.area, 1e-12 * scene.source.area);
    EXPECT_NEAR(packing.spacing, 0.003, 0.02 * 0.003);
    const Discretisation d = make_discretisation(packing.spacing, 1.3, 2000);
    Soil soil = soil_at(packing.points);
    const Wall wall = make_wall(BedLine(scene.source.bed), d);
    NeighbourSearch search(d, 1);
    Neighbours n;
    search.sort(soil);
    search.find(soil, wall, n);
    for (int i = 0; i < soil.count; ++i) EXPECT_LT(n.density[i], 1.03);
}

// A sliver squeezed particles out of its tip and into the bed.
TEST(PackingTest, NobodyStartsOutsideASliver) {
    const Scene scene = scenes::polygon({{0, 3.6}, {6.53, 3.6}, {8.61, 0}, {150, 0}},
                                        {{8.61, 0}, {6.53, 3.6}, {6.24, 2.8}, {7.2, 1.0}}, 60.0, 0.2);
    const BedLine outline(scene.source.outline, true);
    for (const double dl : {0.3, 0.2, 0.1}) {
        const Packing packing = pack_mass(mass_of(scene.source), dl, 1.3);
        for (const Vec2& point : packing.points) {
            EXPECT_GT(outline.nearest(point).distance, 0.0);
        }
    }
}

}  // namespace
}  // namespace runout
