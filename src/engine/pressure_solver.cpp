#include "engine/pressure_solver.h"

#include <algorithm>
#include <cmath>

#include "engine/node_array.h"
#include "engine/operators.h"
#include "engine/parallel.h"
#include "engine/row_passes.h"

namespace runout {
namespace {

constexpr int max_iterations = 1000;
constexpr double coarse_cell_spacings = 4.0;
constexpr double coarse_scale = 1.5;  // makes up for the piecewise constant coarse space
constexpr int steps_per_coarse_build = 15;

}  // namespace

PressureSolver::PressureSolver(const Discretisation& discretisation, double gravity, double length,
                               double tolerance, int threads)
    : discretisation_(discretisation),
      gravity_(gravity),
      relaxation_time_(discretisation.spacing / std::sqrt(gravity * length)),
      tolerance_(tolerance),
      negligible_(1e-12 * discretisation.lattice_stiffness * discretisation.density * gravity *
                  discretisation.spacing),
      threads_(threads) {}

void PressureSolver::set_up(const Neighbours& n, const Soil& soil, const Wall& wall) {
    set_rest(pressure_, soil.count, n.nodes, 0.0);
    set_rest(diagonal_, soil.count, n.nodes, 1.0);
    set_rest(free_, soil.count, n.nodes, char{0});
    const bool all_awake = n.resting.empty();
    for_each_piece(soil.count, threads_, [&](int first, int last) {
        for (int i = first; i < last; ++i) {
            pressure_[i] = soil.pressure[i];
            free_[i] = all_awake || !n.rests(i) ? 1 : 0;
            diagonal_[i] = free_[i] ? n.stiffness_sum[i] : 1.0;
            if (free_[i] && n.density[i] < surface_density) {
                diagonal_[i] += std::max(0.0, discretisation_.lattice_stiffness - n.stiffness_sum[i]);
            }
        }
    });
    for (int a = 0; a < n.active_count(); ++a) {
        const int node = n.first_boundary + a;
        const int b = n.active[a];
        const bool at_surface = n.density[node] < surface_density;
        if (n.boundary_soil[a] == 0) {
            pressure_[node] = 0.0;
        } else if (at_surface && n.boundary_soil[a] < 3) {
            pressure_[node] = 0.25 * discretisation_.density * gravity_ * discretisation_.spacing;
        } else {
            pressure_[node] = wall.pressure[b];
            free_[node] = 1;
        }
        double sum = 0.0;
        for (int k = n.boundary_start[a]; k < n.boundary_start[a + 1]; ++k)
            sum += n.boundary_pairs[k].stiffness;
        for (int k = wall.neighbour_start[b]; k < wall.neighbour_start[b + 1]; ++k)
            sum += wall.neighbour_stiffness[k];
        diagonal_[node] = sum;
    }
    boundary_node_.resize(static_cast<std::size_t>(wall.boundary_count), -1);
    for (const int b : numbered_) boundary_node_[b] = -1;
    for (int a = 0; a < n.active_count(); ++a) boundary_node_[n.active[a]] = n.first_boundary + a;
    make_room(numbered_, n.active.size());
    numbered_.assign(n.active.begin(), n.active.end());
}

/// A p = (wanted - div(v* - dt grad(m p^n) / rho)) / dt + A m p^n. On return product = A p^n. Two passes:
/// product and trial velocity, then its divergence.
void PressureSolver::set_right_hand_side(const Neighbours& n, const Wall& wall, const std::vector<double>& vx,
                                         const std::vector<double>& vy, const PressureStep& step) {
    for (auto* field : {&kept_, &gradient_x_, &gradient_y_}) fit(*field, n.nodes);
    set_beyond_awake(n, trial_velocity_, FloatPair{});
    for (auto* field : {&right_hand_side_, &product_}) set_beyond_awake(n, *field, 0.0);
    for_each_piece(n.nodes, threads_, [&](int first, int last) {
        for (int i = first; i < last; ++i) kept_[i] = step.memory * pressure_[i];
    });
    const double dt = step.dt;
    const double scale = dt / discretisation_.density;
    const double rate = step.correct_density ? 1.0 / std::max(relaxation_time_, 10.0 * dt) : 0.0;
    const auto combine = [&](int node, double divergence) {
        const double wanted = rate * std::max(0.0, n.density[node] - 1.0);
        return (wanted - divergence) / dt + step.memory * product_[node];
    };
    const auto rows = [&](int pass, const PairRows& run, int last) {
        if (pass == 0) {
            pair_kernels().pressure_product(run, diagonal_.data(), pressure_.data(), product_.data());
            pair_kernels().pressure_gradient(run, kept_.data(), gradient_x_.data(), gradient_y_.data());
            for (int i = run.first_row; i < last; ++i) {
                trial_velocity_[i] = {static_cast<float>(vx[i] - scale * gradient_x_[i]),
                                      static_cast<float>(vy[i] - scale * gradient_y_[i])};
            }
        } else {
            pair_kernels().velocity_divergence(run, trial_velocity_.data(), right_hand_side_.data());
            for (int i = run.first_row; i < last; ++i) right_hand_side_[i] = combine(i, right_hand_side_[i]);
        }
    };
    const auto boundary = [&](int pass, int a) {
        const int node = n.first_boundary + a;
        if (pass == 0) {
            multiply_boundary_row(n, wall, a, pressure_, product_);
        } else if (free_[node] && n.density[node] >= surface_density) {
            right_hand_side_[node] = combine(node, boundary_divergence(n, a));
        }
    };
    for_each_pass(n, 2, threads_, rows, boundary);
}

/// Divergence of the trial velocity at active boundary particle `a`.
double PressureSolver::boundary_divergence(const Neighbours& n, int a) const {
    double divergence = 0.0;
    for (int k = n.boundary_start[a]; k < n.boundary_start[a + 1]; ++k) {
        const BoundaryPair& pair = n.boundary_pairs[k];
        divergence += static_cast<double>(trial_velocity_[pair.soil].x) * pair.gx +
                      static_cast<double>(trial_velocity_[pair.soil].y) * pair.gy;
    }
    return divergence;
}

void PressureSolver::refresh_coarse_level(const Neighbours& n, Soil& soil, const Wall& wall) {
    set_rest(aggregate_, soil.count, n.nodes, -1);
    const bool worn = steps_since_build_ >= steps_per_coarse_build ||
                      last_iterations_ > iterations_after_build_ + iterations_after_build_ / 2 + 3;
    if (wall_aggregate_.empty() || worn) {
        coarse_.build(n, soil, wall, diagonal_, free_, coarse_cell_spacings * discretisation_.spacing,
                      aggregate_);
        std::copy_n(aggregate_.begin(), soil.count, soil.aggregate.begin());
        wall_aggregate_.assign(wall.boundary_count, -1);
        for (int a = 0; a < n.active_count(); ++a)
            wall_aggregate_[n.active[a]] = aggregate_[n.first_boundary + a];
        steps_since_build_ = 0;
        return;
    }
    for_each_piece(soil.count, threads_, [&](int first, int last) {
        for (int i = first; i < last; ++i) aggregate_[i] = free_[i] ? soil.aggregate[i] : -1;
    });
    for (int a = 0; a < n.active_count(); ++a) {
        const int node = n.first_boundary + a;
        aggregate_[node] = free_[node] ? wall_aggregate_[n.active[a]] : -1;
    }
    ++steps_since_build_;
}

/// out = A x. Returns x . A x.
double PressureSolver::multiply(const Neighbours& n, const Wall& wall, const std::vector<double>& x,
                                std::vector<double>& out) {
    const std::vector<RowTask>& tasks = n.chunks.tasks;
    return sum_blocks(static_cast<int>(tasks.size()), threads_, partial_, [&](int t) {
        double sum = 0.0;
        do_task(
            n, tasks[t],
            [&](const PairRows& rows, int last) {
                pair_kernels().pressure_product(rows, diagonal_.data(), x.data(), out.data());
                for (int i = rows.first_row; i < last; ++i) sum += x[i] * out[i];
            },
            [&](int a) { sum += multiply_boundary_row(n, wall, a, x, out); });
        return sum;
    });
}

double PressureSolver::multiply_boundary_row(const Neighbours& n, const Wall& wall, int a,
                                             const std::vector<double>& x, std::vector<double>& out) const {
    const int node = n.first_boundary + a;
    const int b = n.active[a];
    double sum = diagonal_[node] * x[node];
    for (int k = n.boundary_start[a]; k < n.boundary_start[a + 1]; ++k) {
        sum -= n.boundary_pairs[k].stiffness * x[n.boundary_pairs[k].soil];
    }
    for (int k = wall.neighbour_start[b]; k < wall.neighbour_start[b + 1]; ++k) {
        const int other = boundary_node_[wall.neighbour[k]];
        if (other >= 0) sum -= wall.neighbour_stiffness[k] * x[other];
    }
    out[node] = free_[node] ? sum : 0.0;
    return x[node] * out[node];
}

/// Gives each node the residual that `renew(i)` returns, and sums it over the coarse cells.
template <class Function>
ResidualNorms PressureSolver::renew_residual(const Function& renew) {
    return sum_blocks(static_cast<int>(parts_.size()), threads_, partial_norms_, [&](int p) {
        NodePart& part = parts_[p];
        part.clear();
        ResidualNorms norms;
        for (int i = part.first; i < part.last; ++i) {
            const double r = renew(i);
            residual_[i] = r;
            norms += {r * r, r * r / diagonal_[i]};
            if (aggregate_[i] >= 0) part.sum[aggregate_[i] - part.low] += r;
        }
        return norms;
    });
}

/// The next direction: z + beta times the last, z = D^-1 r + coarse correction.
void PressureSolver::turn(double beta, const double* coarse) {
    for_each_piece(static_cast<int>(pressure_.size()), threads_, [&](int first, int last) {
        for (int i = first; i < last; ++i) {
            const double added = aggregate_[i] >= 0 ? coarse_scale * coarse[aggregate_[i]] : 0.0;
            direction_[i] = residual_[i] / diagonal_[i] + added + beta * direction_[i];
        }
    });
}

/// Conjugate gradients from the pressure at hand, whose product with A is at hand as well. r.z needs no pass
/// of its own: it is the sum of what the two levels give.
PressureSolve PressureSolver::iterate(const Neighbours& n, const Wall& wall) {
    PressureSolve result;
    fit(residual_, n.nodes);
    set_all(direction_, n.nodes, 0.0);
    const double norm = std::sqrt(sum_pieces(n.nodes, threads_, partial_, [&](int first, int last) {
        double sum = 0.0;
        for (int i = first; i < last; ++i) sum += right_hand_side_[i] * right_hand_side_[i];
        return sum;
    }));
    const double target = std::max(tolerance_ * norm, negligible_);
    ResidualNorms left =
        renew_residual([&](int i) { return free_[i] ? right_hand_side_[i] - product_[i] : 0.0; });
    double rz_old = 1.0;
    while (std::sqrt(left.squared) > target && result.iterations < max_iterations) {
        const CoarseCorrection coarse = coarse_.solve(parts_);
        const double rz = left.scaled + coarse_scale * coarse.product;
        turn(result.iterations == 0 ? 0.0 : rz / rz_old, coarse.value);
        const double alpha = rz / multiply(n, wall, direction_, product_);
        left = renew_residual([&](int i) {
            pressure_[i] += alpha * direction_[i];
            return residual_[i] - alpha * product_[i];
        });
        rz_old = rz;
        ++result.iterations;
    }
    result.residual = norm > 0.0 ? std::sqrt(left.squared) / norm : 0.0;
    result.converged = std::sqrt(left.squared) <= target;
    return result;
}

/// Negative pressure is cut off, at zero unless the soil is cohesive; at a free surface always, where it
/// would draw grains together that do not touch.
void PressureSolver::cut_off_tension(const Neighbours& n) {
    const bool bears_tension = tension_ > 0.0;
    for_each_piece(n.nodes, threads_, [&](int first, int last) {
        for (int i = first; i < last; ++i) {
            const double least = bears_tension && n.density[i] >= body_density ? -tension_ : 0.0;
            pressure_[i] = std::max(pressure_[i], least);
        }
    });
}

/// Sets what soil and wall carry into the next step. Returns the highest pressure of the soil in this one.
double PressureSolver::hand_over(const Neighbours& n, double renewal, Soil& soil, Wall& wall) {
    const auto renewed = [&](double carried, int node) {
        return free_[node] ? carried + renewal * (pressure_[node] - carried) : pressure_[node];
    };
    for (int a = 0; a < n.active_count(); ++a) {
        double& carried = wall.pressure[n.active[a]];
        carried = renewed(carried, n.first_boundary + a);
    }
    return max_pieces(soil.count, threads_, partial_, [&](int first, int last) {
        double highest = 0.0;
        for (int i = first; i < last; ++i) {
            soil.pressure[i] = renewed(soil.pressure[i], i);
            highest = std::max(highest, pressure_[i]);
        }
        return highest;
    });
}

PressureSolve PressureSolver::solve(const Neighbours& n, Soil& soil, Wall& wall,
                                    const std::vector<double>& vx, const std::vector<double>& vy,
                                    const PressureStep& step) {
    set_up(n, soil, wall);
    PressureStep start = step;
    if (filter_) {
        filter_->apply(n, soil, pressure_);
        start.memory = 1.0;
    }
    set_right_hand_side(n, wall, vx, vy, start);
    refresh_coarse_level(n, soil, wall);
    cut_into_parts(aggregate_, threads_, parts_);
    PressureSolve result = iterate(n, wall);
    last_iterations_ = result.iterations;
    if (steps_since_build_ == 0) iterations_after_build_ = result.iterations;
    cut_off_tension(n);
    result.highest = hand_over(n, step.renewal, soil, wall);
    return result;
}

}  // namespace runout
