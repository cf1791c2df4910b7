#include "engine/friction/friction.h"

#include <algorithm>
#include <cmath>

#include "engine/pairs/operators.h"
#include "engine/pairs/row_passes.h"
#include "engine/pairs/slipping_base.h"
#include "engine/pairs/strain_rate.h"
#include "engine/threads/node_array.h"

namespace runout {
namespace {

constexpr double first_momentum_term = 4.0;  // t of Nesterov's sequence: 1, 1.6, 2.2, 2.8, 3.3, 3.8 ...

}  // namespace

Friction::Friction(const Discretisation& discretisation, YieldStrength yield, FrictionScheme scheme,
                   int iterations)
    : discretisation_(discretisation), yield_(std::move(yield)), scheme_(scheme), iterations_(iterations) {}

void Friction::make_room(const Neighbours& n) {
    for (auto* field : {&base_velocity_, &force_}) fit(*field, n.nodes);
    for (auto* field : {&stress_, &ahead_, &velocity_}) set_rest(*field, n.soil_count, n.nodes, FloatPair{});
    set_rest(pressure_, n.soil_count, n.nodes, 0.0);
    set_rest(strength_, n.soil_count, n.nodes, 0.0F);
    if (yield_.depends_on_rate()) fit(strain_rate_, n.nodes);
    if (yield_.cohesive())
        for (int c = 0; c < 4; ++c) set_all(no_correction_[c], n.nodes, c == 0 || c == 3 ? 1.0F : 0.0F);
}

void Friction::load(const ParticleSystem& particles, int chunk) {
    const Neighbours& n = particles.neighbours;
    const Soil& soil = particles.soil;
    const Wall& wall = particles.wall;
    for_each_soil(n, chunk, [&](int i) {
        pressure_[i] = soil.pressure[i];
        stress_[i] = {static_cast<float>(soil.sxx[i]), static_cast<float>(soil.sxy[i])};
        ahead_[i] = stress_[i];
        velocity_[i] = {static_cast<float>(soil.vx[i]), static_cast<float>(soil.vy[i])};
    });
    for_each_boundary(n, chunk, [&](int a) {
        const int node = n.first_boundary_node + a;
        const int b = n.active[a];
        pressure_[node] = wall.pressure[b];
        stress_[node] = {static_cast<float>(wall.sxx[b]), static_cast<float>(wall.sxy[b])};
        ahead_[node] = stress_[node];
    });
}

/// Calls f(block, i, gradient) with the plain gradient of velocity_ at every row of soil of a chunk, slip on
/// the base left out.
template <class Function>
void Friction::for_each_gradient(const ParticleSystem& particles, int chunk, const Function& f) const {
    const Neighbours& n = particles.neighbours;
    const RowChunk& c = n.chunks.list[chunk];
    for (int b = c.first_block; b < c.last_block; ++b) {
        const PairRows rows = pair_rows(n.blocks[b], n);
        VelocityGradients g;
        find_gradients(rows, particles, g);
        for (int k = 0; k < rows_per_block && rows.first_row + k < n.soil_count; ++k)
            f(n.blocks[b], rows.first_row + k, VelocityGradient{g.xx[k], g.xy[k], g.yx[k], g.yy[k]});
    }
}

/// |e| of the velocity at the start of the step. A boundary particle has the mean rate of the soil on it.
void Friction::find_strain_rate(TeamMember& member, const ParticleSystem& particles) {
    const Neighbours& n = particles.neighbours;
    const auto of_soil = [&](const PairBlock& block, int i, const VelocityGradient& plain) {
        const bool slips = n.nearest_boundary[i] >= 0 && particles.wall.slips_at(n.nearest_boundary[i]);
        const VelocityGradient whole =
            slips ? plain : gradient_without_slip(particles, block, i, plain, discretisation_.spacing);
        const VelocityGradient g = whole.corrected(n, i);
        strain_rate_[i] = std::hypot(g.exx(), g.exy());
    };
    const auto of_boundary = [&](int a) {
        double sum = 0.0;
        double weight = 0.0;
        for (int k = n.boundary_start[a]; k < n.boundary_start[a + 1]; ++k) {
            sum += n.boundary_pairs[k].stiffness * strain_rate_[n.boundary_pairs[k].soil];
            weight += n.boundary_pairs[k].stiffness;
        }
        strain_rate_[n.first_boundary_node + a] = weight > 0.0 ? sum / weight : 0.0;
    };
    member.for_each_pass(2, [&](int pass, int chunk) {
        if (pass == 1) return for_each_boundary(n, chunk, of_boundary);
        for_each_gradient(particles, chunk, of_soil);
    });
}

void Friction::find_strength(const Neighbours& n, int chunk, const std::vector<double>* pore_pressure) {
    const auto find = [&](int node, int wall_index) {
        const double pore = pore_pressure != nullptr ? (*pore_pressure)[node] : 0.0;
        const double rate = yield_.depends_on_rate() ? strain_rate_[node] : 0.0;
        strength_[node] = static_cast<float>(yield_.at(wall_index, pressure_[node], pore, rate));
    };
    for_each_soil(n, chunk, [&](int i) { find(i, -1); });
    for_each_boundary(n, chunk, [&](int a) { find(n.first_boundary_node + a, n.active[a]); });
}

void Friction::save(int chunk, ParticleSystem& particles) const {
    const Neighbours& n = particles.neighbours;
    Soil& soil = particles.soil;
    Wall& wall = particles.wall;
    for_each_soil(n, chunk, [&](int i) {
        soil.sxx[i] = stress_[i].x;
        soil.sxy[i] = stress_[i].y;
    });
    for_each_boundary(n, chunk, [&](int a) {
        wall.sxx[n.active[a]] = stress_[n.first_boundary_node + a].x;
        wall.sxy[n.active[a]] = stress_[n.first_boundary_node + a].y;
    });
}

/// Base velocity = v^n + dt (g - grad p / rho), with the pressure carried from the last step. The stress
/// turns with the soil (Jaumann rate), which keeps |s|.
void Friction::start_rows(const PairRows& rows, int last, const ParticleSystem& particles,
                          const FrictionStep& step, NodeVectors& gradient) {
    const Neighbours& n = particles.neighbours;
    const Soil& soil = particles.soil;
    const double scale = step.dt / discretisation_.density;
    const Vec2 gain = step.dt * step.body;
    pair_kernels().pressure_gradient(rows, pressure_.data(), gradient.x.data(), gradient.y.data());
    for (int i = rows.first_row; i < last; ++i) {
        base_velocity_[i] = {
            static_cast<float>(soil.vx[i] - scale * gradient.x[i] + gain.x() + step.dt * soil.contact_x[i]),
            static_cast<float>(soil.vy[i] - scale * gradient.y[i] + gain.y() + step.dt * soil.contact_y[i])};
    }
    StressRotation rotation;
    for (int c = 0; c < 4; ++c) rotation.correction[c] = n.correction[c].data();
    rotation.dt = static_cast<float>(step.dt);
    rotation.stress = stress_.data();
    VelocityGradients gradients;
    find_gradients(rows, particles, gradients);
    pair_kernels().rotate_stress(rows, gradients, rotation);
    std::copy_n(&stress_[rows.first_row], rows.slices * lanes, &ahead_[rows.first_row]);
}

/// Plain gradients of velocity_, slip on the base left out.
void Friction::find_gradients(const PairRows& rows, const ParticleSystem& particles,
                              VelocityGradients& gradients) const {
    pair_kernels().velocity_gradient(rows, velocity_.data(), gradients);
    leave_out_slip(rows, particles.neighbours, particles.wall, velocity_.data(), gradients);
}

/// div s into force_.
void Friction::find_force(const PairRows& rows, const ParticleSystem& particles,
                          const std::vector<FloatPair>& stress) {
    pair_kernels().stress_divergence(rows, stress.data(), force_.data());
    carry_by_wall(rows, particles.neighbours, particles.wall, {stress.data(), pressure_.data()},
                  force_.data());
}

/// v~ = base velocity - dt div(ahead s) / rho.
void Friction::trial_velocity(const PairRows& rows, int last, const ParticleSystem& particles, double dt) {
    const auto scale = static_cast<float>(dt / discretisation_.density);
    find_force(rows, particles, ahead_);
    for (int i = rows.first_row; i < last; ++i) {
        velocity_[i] = {base_velocity_[i].x - scale * force_[i].x, base_velocity_[i].y - scale * force_[i].y};
    }
}

/// Correction matrices of the velocity gradient that stress grows with: none for cohesive soil.
const std::array<std::vector<float>, 4>& Friction::correction(const Neighbours& n) const {
    return yield_.cohesive() ? no_correction_ : n.correction;
}

/// s <- bound(ahead + 2 r e(v~)), then ahead <- s + momentum (s - old s). r = 0.25 rho dl^2 / dt keeps the
/// iteration stable for the lattice's stiffest mode.
void Friction::project(const PairRows& rows, const ParticleSystem& particles, double step, double momentum) {
    VelocityGradients gradients;
    find_gradients(rows, particles, gradients);
    StressUpdate update;
    for (int c = 0; c < 4; ++c) update.correction[c] = correction(particles.neighbours)[c].data();
    update.strength = strength_.data();
    update.step = static_cast<float>(step);
    update.momentum = static_cast<float>(momentum);
    update.stress = stress_.data();
    update.ahead = ahead_.data();
    pair_kernels().update_stress(rows, gradients, update);
}

/// As PairKernels::update_stress, at active boundary particle `a`.
void Friction::project_boundary(const Neighbours& n, int a, double step, float momentum) {
    const int i = n.first_boundary_node + a;
    const VelocityGradient g = boundary_velocity_gradient(n, a, velocity_.data()).corrected(correction(n), i);
    const double trial_xx = ahead_[i].x + step * g.exx();
    const double trial_xy = ahead_[i].y + step * g.exy();
    const double size = std::sqrt(trial_xx * trial_xx + trial_xy * trial_xy);
    const double scale = size > strength_[i] ? strength_[i] / size : 1.0;
    const FloatPair bound{static_cast<float>(scale * trial_xx), static_cast<float>(scale * trial_xy)};
    ahead_[i] = {bound.x + momentum * (bound.x - stress_[i].x),
                 bound.y + momentum * (bound.y - stress_[i].y)};
    stress_[i] = bound;
}

/// Eq. 8 from the velocity at the start of the step.
void Friction::yield_from_strain_rate(const ParticleSystem& particles, int chunk) {
    const Neighbours& n = particles.neighbours;
    const auto update = [&](int i, const VelocityGradient& plain) {
        const VelocityGradient g = plain.corrected(n, i);
        const double rate = std::hypot(g.exx(), g.exy());
        const double scale = rate > 0.0 ? strength_[i] / rate : 0.0;
        stress_[i] = {static_cast<float>(scale * g.exx()), static_cast<float>(scale * g.exy())};
    };
    for_each_gradient(particles, chunk,
                      [&](const PairBlock&, int i, const VelocityGradient& plain) { update(i, plain); });
    for_each_boundary(n, chunk, [&](int a) {
        update(n.first_boundary_node + a, boundary_velocity_gradient(n, a, velocity_.data()));
    });
}

/// v* = v^n + dt (g - div s / rho), eq. 3.
void Friction::final_velocity(const PairRows& rows, int last, const ParticleSystem& particles,
                              const FrictionStep& step, NodeVectors& predicted) {
    const Soil& soil = particles.soil;
    const double scale = step.dt / discretisation_.density;
    const Vec2 gain = step.dt * step.body;
    find_force(rows, particles, stress_);
    for (int i = rows.first_row; i < last; ++i) {
        predicted.x[i] = soil.vx[i] - scale * force_[i].x + gain.x();
        predicted.y[i] = soil.vy[i] - scale * force_[i].y + gain.y();
    }
}

/// Nesterov's sequence from its sixth term on. The small momenta of its first terms are for a start that is
/// far off; the stress of the last step is a good start, and they would only cost iterations.
void Friction::set_momenta(int iterations) {
    momenta_.clear();
    double t = first_momentum_term;
    for (int k = 0; k < iterations; ++k) {
        const double next = 0.5 * (1.0 + std::sqrt(1.0 + 4.0 * t * t));
        momenta_.push_back((t - 1.0) / next);
        t = next;
    }
}

void Friction::predict(ParticleSystem& particles, const FrictionStep& step, NodeVectors& predicted,
                       NodeVectors& gradient) {
    const Neighbours& n = particles.neighbours;
    make_room(n);
    for (auto* field : {&gradient.x, &gradient.y}) fit(*field, n.first_boundary_node);
    for (auto* field : {&predicted.x, &predicted.y}) set_beyond_awake(n, *field, 0.0);
    set_momenta(step.iterations > 0 ? step.iterations : iterations_);
    const auto start = [&](int chunk) {
        find_strength(n, chunk, step.pore_pressure);
        for_each_awake(n, chunk, [&](const PairRows& rows, int last) {
            start_rows(rows, last, particles, step, gradient);
        });
    };
    const auto finish = [&](int chunk) {
        for_each_awake(n, chunk, [&](const PairRows& rows, int last) {
            final_velocity(rows, last, particles, step, predicted);
        });
        save(chunk, particles);
    };
    with_team(n.chunks, signals_, [&](TeamMember& member) {
        member.for_each_pass(1, [&](int, int chunk) { load(particles, chunk); });
        if (yield_.depends_on_rate()) find_strain_rate(member, particles);
        if (scheme_ == FrictionScheme::projected) return iterate(member, particles, step.dt, start, finish);
        member.for_each_pass(2, [&](int pass, int chunk) {
            if (pass == 1) return finish(chunk);
            find_strength(n, chunk, step.pore_pressure);
            yield_from_strain_rate(particles, chunk);
        });
    });
}

/// Passes: the start, then for each iteration a trial velocity and a projection, then the end.
template <class Start, class Finish>
void Friction::iterate(TeamMember& member, const ParticleSystem& particles, double dt, const Start& start,
                       const Finish& finish) {
    const Neighbours& n = particles.neighbours;
    const int final_pass = 2 * static_cast<int>(momenta_.size()) + 1;
    const double stress_step = 0.5 * discretisation_.density * discretisation_.volume() / dt;
    const auto try_velocity = [&](int chunk) {
        for_each_awake(n, chunk,
                       [&](const PairRows& rows, int last) { trial_velocity(rows, last, particles, dt); });
    };
    const auto project_stress = [&](int chunk, double momentum) {
        for_each_awake(n, chunk,
                       [&](const PairRows& rows, int) { project(rows, particles, stress_step, momentum); });
        for_each_boundary(n, chunk,
                          [&](int a) { project_boundary(n, a, stress_step, static_cast<float>(momentum)); });
    };
    member.for_each_pass(final_pass + 1, [&](int pass, int chunk) {
        if (pass == 0) return start(chunk);
        if (pass == final_pass) return finish(chunk);
        if (pass % 2 == 1) return try_velocity(chunk);
        project_stress(chunk, momenta_[pass / 2 - 1]);
    });
}

}  // namespace runout
