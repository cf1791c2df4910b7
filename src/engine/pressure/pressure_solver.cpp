#include "engine/pressure/pressure_solver.h"

#include <algorithm>
#include <cmath>

#include "engine/pairs/operators.h"
#include "engine/threads/node_array.h"

namespace runout {
namespace {

constexpr int max_iterations = 1000;
constexpr double coarse_scale = 1.5;  // makes up for a coarse correction that is constant on each cell
constexpr int steps_per_coarse_build = 15;

}  // namespace

PressureSolver::PressureSolver(const Discretisation& discretisation, double gravity, double length,
                               double tolerance)
    : discretisation_(discretisation),
      gravity_(gravity),
      relaxation_time_(discretisation.spacing / std::sqrt(gravity * length)),
      tolerance_(tolerance),
      negligible_(1e-12 * discretisation.lattice_stiffness * discretisation.density * gravity *
                  discretisation.spacing),
      coarse_(discretisation.spacing) {}

void PressureSolver::set_up(const ParticleSystem& particles) {
    const Neighbours& n = particles.neighbours;
    const Soil& soil = particles.soil;
    set_rest(pressure_, soil.count, n.nodes, 0.0);
    set_rest(diagonal_, soil.count, n.nodes, 1.0);
    set_rest(free_, soil.count, n.nodes, char{0});
    const bool all_awake = n.asleep.empty();
    for_each_chunk(n.chunks, [&](int chunk) {
        for_each_soil(n, chunk, [&](int i) {
            pressure_[i] = soil.pressure[i];
            free_[i] = all_awake || !n.is_asleep(i) ? 1 : 0;
            diagonal_[i] = free_[i] ? n.stiffness_sum[i] : 1.0;
            if (free_[i] && n.density[i] < surface_density) {
                diagonal_[i] += std::max(0.0, discretisation_.lattice_stiffness - n.stiffness_sum[i]);
            }
        });
        for_each_boundary(n, chunk, [&](int a) { set_up_boundary(particles, a); });
    });
}

void PressureSolver::set_up_boundary(const ParticleSystem& particles, int a) {
    const Neighbours& n = particles.neighbours;
    const Wall& wall = particles.wall;
    const int node = n.first_boundary_node + a;
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
    for (int k = n.boundary_start[a]; k < n.boundary_start[a + 1]; ++k) sum += n.boundary_pairs[k].stiffness;
    for (int k = wall.neighbour_start[b]; k < wall.neighbour_start[b + 1]; ++k)
        sum += wall.neighbour_stiffness[k];
    diagonal_[node] = sum;
}

/// Builds the coarse level anew where it is old, or where iterations have become many; else uses it on.
void PressureSolver::set_up_coarse_level(const ParticleSystem& particles) {
    const bool worn = steps_since_build_ >= steps_per_coarse_build ||
                      last_iterations_ > iterations_after_build_ + iterations_after_build_ / 2 + 3;
    const FineLevel fine{particles, diagonal_, free_};
    if (coarse_.empty() || worn) {
        coarse_.build(fine);
        steps_since_build_ = 0;
    } else {
        coarse_.carry_on(fine);
        ++steps_since_build_;
    }
}

void PressureSolver::make_room(const Neighbours& n) {
    for (auto* field : {&residual_, &direction_}) set_rest(*field, n.soil_count, n.nodes, 0.0);
    set_beyond_awake(n, trial_velocity_, FloatPair{});
    for (auto* field : {&right_hand_side_, &product_}) set_beyond_awake(n, *field, 0.0);
    fit(partial_, n.chunks.count());
    fit(partial_norms_, n.chunks.count());
}

/// A p = (wanted - div(v* - dt grad(m p^n) / rho)) / dt + A m p^n, and the residual of p = p^n. Two passes:
/// A p^n and trial velocity, then its divergence.
void PressureSolver::find_right_hand_side(TeamMember& member, const ParticleSystem& particles,
                                          const NodeVectors& predicted, const PressureStep& step,
                                          NodeVectors& gradient) {
    const Neighbours& n = particles.neighbours;
    const double dt = step.dt;
    const double scale = step.memory * dt / discretisation_.density;
    const double rate = step.correct_density ? 1.0 / std::max(relaxation_time_, 10.0 * dt) : 0.0;
    const auto combine = [&](int node, double divergence) {
        const double wanted = rate * std::max(0.0, n.density[node] - 1.0);
        return (wanted - divergence) / dt + step.memory * product_[node];
    };
    const auto try_velocity = [&](const PairRows& rows, int last) {
        pair_kernels().pressure_gradient(rows, pressure_.data(), gradient.x.data(), gradient.y.data());
        for (int i = rows.first_row; i < last; ++i) {
            trial_velocity_[i] = {static_cast<float>(predicted.x[i] - scale * gradient.x[i]),
                                  static_cast<float>(predicted.y[i] - scale * gradient.y[i])};
        }
    };
    const auto find_divergence = [&](const PairRows& rows, int last) {
        pair_kernels().velocity_divergence(rows, trial_velocity_.data(), right_hand_side_.data());
        for (int i = rows.first_row; i < last; ++i) right_hand_side_[i] = combine(i, right_hand_side_[i]);
    };
    member.for_each_pass(2, [&](int pass, int chunk) {
        if (pass == 0) {
            multiply(particles, chunk, pressure_, product_);
            return for_each_awake(n, chunk, try_velocity);
        }
        for_each_awake(n, chunk, find_divergence);
        for_each_boundary(n, chunk, [&](int a) {
            const int node = n.first_boundary_node + a;
            if (free_[node] && n.density[node] >= surface_density)
                right_hand_side_[node] = combine(node, boundary_divergence(n, a));
        });
        double whole = 0.0;
        renew_residual(n, chunk, [&](int i) {
            whole += right_hand_side_[i] * right_hand_side_[i];
            direction_[i] = 0.0;
            return free_[i] ? right_hand_side_[i] - product_[i] : 0.0;
        });
        partial_norms_[chunk].whole = whole;
    });
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

/// out = A x in the rows of a chunk. Returns what they add to x . A x.
double PressureSolver::multiply(const ParticleSystem& particles, int chunk, const std::vector<double>& x,
                                std::vector<double>& out) const {
    const Neighbours& n = particles.neighbours;
    double sum = 0.0;
    for_each_awake(n, chunk, [&](const PairRows& rows, int last) {
        pair_kernels().pressure_product(rows, diagonal_.data(), x.data(), out.data());
        for (int i = rows.first_row; i < last; ++i) sum += x[i] * out[i];
    });
    for_each_boundary(n, chunk, [&](int a) { sum += multiply_boundary_row(particles, a, x, out); });
    return sum;
}

double PressureSolver::multiply_boundary_row(const ParticleSystem& particles, int a,
                                             const std::vector<double>& x, std::vector<double>& out) const {
    const Neighbours& n = particles.neighbours;
    const Wall& wall = particles.wall;
    const int node = n.first_boundary_node + a;
    const int b = n.active[a];
    double sum = diagonal_[node] * x[node];
    for (int k = n.boundary_start[a]; k < n.boundary_start[a + 1]; ++k) {
        sum -= n.boundary_pairs[k].stiffness * x[n.boundary_pairs[k].soil];
    }
    for (int k = wall.neighbour_start[b]; k < wall.neighbour_start[b + 1]; ++k) {
        const int other = n.node_of_boundary[wall.neighbour[k]];
        if (other >= 0) sum -= wall.neighbour_stiffness[k] * x[other];
    }
    out[node] = free_[node] ? sum : 0.0;
    return x[node] * out[node];
}

/// Gives each node i of a chunk the residual renew(i), and sums the residuals over the coarse cells.
template <class Function>
void PressureSolver::renew_residual(const Neighbours& n, int chunk, const Function& renew) {
    const std::vector<int>& cell = coarse_.cell();
    CellSums& cells = coarse_.sums(chunk);
    cells.clear();
    ResidualNorms norms;
    for_each_node(n, chunk, [&](int i) {
        const double r = renew(i);
        residual_[i] = r;
        norms.squared += r * r;
        norms.scaled += r * r / diagonal_[i];
        if (cell[i] >= 0) cells.sum[cell[i] - cells.low] += r;
    });
    partial_norms_[chunk] = norms;
}

/// The next direction in a chunk: z + beta times the last, with z = D^-1 r + coarse correction. That of
/// sleeping soil stays 0.
void PressureSolver::renew_direction(const Neighbours& n, int chunk, double beta, const double* coarse) {
    const std::vector<int>& cell = coarse_.cell();
    const auto renew = [&](int i) {
        const double added = cell[i] >= 0 ? coarse_scale * coarse[cell[i]] : 0.0;
        direction_[i] = residual_[i] / diagonal_[i] + added + beta * direction_[i];
    };
    for_each_awake(n, chunk, [&](const PairRows& rows, int last) {
        for (int i = rows.first_row; i < last; ++i) renew(i);
    });
    for_each_boundary(n, chunk, [&](int a) { renew(n.first_boundary_node + a); });
}

/// State of the conjugate gradients that all threads see.
struct PressureSolver::Iteration {
    PressureSolve result;
    double norm = 0;    ///< of the right-hand side
    double target = 0;  ///< of the residual
    double rz = 1;      ///< r . z
    double alpha = 0;
    double beta = 0;
    const double* coarse = nullptr;  ///< correction per coarse cell; null: that is the end
};

/// Called when the residual is known. If it is small enough the iteration ends; else the coarse correction is
/// found. r . z needs no pass of its own, being the sum of what the two levels give.
void PressureSolver::precondition(Iteration& now) {
    const auto left = sum_of(partial_norms_);
    const double size = std::sqrt(left.squared);
    PressureSolve& result = now.result;
    result.residual = now.norm > 0.0 ? size / now.norm : 0.0;
    result.converged = size <= now.target;
    now.coarse = nullptr;
    if (result.converged || std::isnan(size) || result.iterations >= max_iterations) return;
    const CoarseCorrection coarse = coarse_.solve();
    const double rz = left.scaled + coarse_scale * coarse.product;
    now.beta = result.iterations == 0 ? 0.0 : rz / now.rz;
    now.rz = rz;
    now.coarse = coarse.value;
}

/// Conjugate gradients, from the pressure and the residual as they are.
void PressureSolver::iterate(TeamMember& member, const ParticleSystem& particles, Iteration& now) {
    const Neighbours& n = particles.neighbours;
    member.synchronise([&] {
        now.norm = std::sqrt(sum_of(partial_norms_).whole);
        now.target = std::max(tolerance_ * now.norm, negligible_);
        precondition(now);
    });
    while (now.coarse != nullptr) {
        member.for_each_pass(2, [&, beta = now.beta, coarse = now.coarse](int pass, int chunk) {
            if (pass == 0) return renew_direction(n, chunk, beta, coarse);
            partial_[chunk] = multiply(particles, chunk, direction_, product_);
        });
        member.synchronise([&] { now.alpha = now.rz / sum_of(partial_); });
        member.for_each_chunk([&, alpha = now.alpha](int chunk) {
            renew_residual(n, chunk, [&](int i) {
                pressure_[i] += alpha * direction_[i];
                return residual_[i] - alpha * product_[i];
            });
        });
        member.synchronise([&] {
            ++now.result.iterations;
            precondition(now);
        });
    }
}

/// Cuts off negative pressure: at zero, or in the body of cohesive soil at the tension that it bears. (Loose
/// grains bear none: it would draw grains together that do not touch.) Sets what soil and wall carry into the
/// next step. Returns the highest pressure of this step in the soil of the chunk.
double PressureSolver::carry_pressure(int chunk, double renewal, ParticleSystem& particles) {
    const Neighbours& n = particles.neighbours;
    Soil& soil = particles.soil;
    Wall& wall = particles.wall;
    const auto settle = [&](double& carried, int node) {
        const double least = tension_ > 0.0 && n.density[node] >= body_density ? -tension_ : 0.0;
        pressure_[node] = std::max(pressure_[node], least);
        carried = free_[node] ? carried + renewal * (pressure_[node] - carried) : pressure_[node];
    };
    double highest = 0.0;
    for_each_soil(n, chunk, [&](int i) {
        settle(soil.pressure[i], i);
        highest = std::max(highest, pressure_[i]);
    });
    for_each_boundary(n, chunk,
                      [&](int a) { settle(wall.pressure[n.active[a]], n.first_boundary_node + a); });
    return highest;
}

void PressureSolver::find_gradient(const Neighbours& n, NodeVectors& gradient) const {
    for_each_chunk(n.chunks, [&](int chunk) {
        for_each_awake(n, chunk, [&](const PairRows& rows, int) {
            pair_kernels().pressure_gradient(rows, pressure_.data(), gradient.x.data(), gradient.y.data());
        });
    });
}

PressureSolve PressureSolver::solve(ParticleSystem& particles, const NodeVectors& predicted,
                                    const PressureStep& step, NodeVectors& gradient) {
    const Neighbours& n = particles.neighbours;
    for (auto* field : {&gradient.x, &gradient.y}) fit(*field, n.first_boundary_node);
    set_up(particles);
    PressureStep start = step;
    if (filter_) {
        filter_->apply(n, particles.soil, pressure_);
        start.memory = 1.0;
    }
    set_up_coarse_level(particles);
    make_room(n);
    Iteration now;
    with_team(n.chunks, signals_, [&](TeamMember& member) {
        find_right_hand_side(member, particles, predicted, start, gradient);
        iterate(member, particles, now);
        member.for_each_chunk(
            [&](int chunk) { partial_[chunk] = carry_pressure(chunk, step.renewal, particles); });
    });
    find_gradient(n, gradient);
    last_iterations_ = now.result.iterations;
    if (steps_since_build_ == 0) iterations_after_build_ = now.result.iterations;
    now.result.highest = *std::max_element(partial_.begin(), partial_.end());
    return now.result;
}

}  // namespace runout
