#include "engine/friction.h"

#include <algorithm>
#include <cmath>

#include "engine/operators.h"
#include "engine/parallel.h"

namespace runout {

double interface_strength(const Material& material, const Effects& effects) {
    const double own = std::sin(material.friction_angle);
    return effects.base_friction ? std::min(own, std::tan(effects.base_friction->angle)) : own;
}

Friction::Friction(const Discretisation& discretisation, const Material& material, const Effects& effects,
                   const RunSettings& run, int threads)
    : discretisation_(discretisation),
      sin_phi_(std::sin(material.friction_angle)),
      interface_strength_(interface_strength(material, effects)),
      gravity_(run.gravity),
      scheme_(run.friction),
      iterations_(run.friction_iterations),
      threads_(threads) {}

void Friction::load(const Neighbours& n, const Soil& soil, const Wall& wall) {
    for (auto* field : {&pressure_, &pressure_x_, &pressure_y_}) field->assign(n.nodes, 0.0);
    for (auto* field : {&strength_, &sxx_, &sxy_, &ahead_sxx_, &ahead_sxy_, &base_vx_, &base_vy_, &vx_, &vy_,
                        &force_x_, &force_y_}) {
        field->assign(n.nodes, 0.0F);
    }
    for (int i = 0; i < soil.count; ++i) {
        pressure_[i] = soil.pressure[i];
        sxx_[i] = static_cast<float>(soil.sxx[i]);
        sxy_[i] = static_cast<float>(soil.sxy[i]);
        vx_[i] = static_cast<float>(soil.vx[i]);
        vy_[i] = static_cast<float>(soil.vy[i]);
    }
    for (int a = 0; a < n.active_count(); ++a) {
        const int node = n.first_boundary + a;
        pressure_[node] = wall.pressure[n.active[a]];
        sxx_[node] = static_cast<float>(wall.sxx[n.active[a]]);
        sxy_[node] = static_cast<float>(wall.sxy[n.active[a]]);
    }
    for (int i = 0; i < n.nodes; ++i)
        strength_[i] = static_cast<float>(std::max(pressure_[i], 0.0) * sin_phi_);
    if (interface_strength_ < sin_phi_) weaken_interface(n);
}

void Friction::weaken_interface(const Neighbours& n) {
    const auto weaken = [&](int node) {
        strength_[node] = static_cast<float>(std::max(pressure_[node], 0.0) * interface_strength_);
    };
    for (int i = 0; i < n.soil_count; ++i) {
        if (n.nearest_boundary[i] >= 0) weaken(i);
    }
    for (int a = 0; a < n.active_count(); ++a) weaken(n.first_boundary + a);
}

void Friction::save(const Neighbours& n, Soil& soil, Wall& wall) const {
    for (int i = 0; i < soil.count; ++i) {
        soil.sxx[i] = sxx_[i];
        soil.sxy[i] = sxy_[i];
    }
    std::fill(wall.sxx.begin(), wall.sxx.end(), 0.0);
    std::fill(wall.sxy.begin(), wall.sxy.end(), 0.0);
    for (int a = 0; a < n.active_count(); ++a) {
        wall.sxx[n.active[a]] = sxx_[n.first_boundary + a];
        wall.sxy[n.active[a]] = sxy_[n.first_boundary + a];
    }
}

/// On return base velocity = v^n + dt (g - grad p / rho): the last known pressure included.
void Friction::apply_pressure(const Neighbours& n, const Soil& soil, double dt) {
    const double scale = dt / discretisation_.density;
    for_each_block(static_cast<int>(n.blocks.size()), threads_, [&](int b) {
        pair_kernels().pressure_gradient(pair_rows(n.blocks[b], n), pressure_.data(), pressure_x_.data(),
                                         pressure_y_.data());
        const int last = std::min(n.blocks[b].first_row + rows_per_block, n.soil_count);
        for (int i = n.blocks[b].first_row; i < last; ++i) {
            base_vx_[i] = static_cast<float>(soil.vx[i] - scale * pressure_x_[i]);
            base_vy_[i] = static_cast<float>(soil.vy[i] - scale * pressure_y_[i] - dt * gravity_);
        }
    });
}

/// The stress turns with the soil (Jaumann); |s| is kept.
void Friction::rotate(const Neighbours& n, double dt) {
    for_each_block(static_cast<int>(n.blocks.size()), threads_, [&](int b) {
        for_each_velocity_gradient(n.blocks[b], n, vx_.data(), vy_.data(),
                                   [&](int i, const VelocityGradient& plain) {
                                       const double angle = 2.0 * dt * plain.corrected(n, i).spin();
                                       const double c = std::cos(angle);
                                       const double s = std::sin(angle);
                                       const double sxx = sxx_[i];
                                       const double sxy = sxy_[i];
                                       sxx_[i] = static_cast<float>(c * sxx - s * sxy);
                                       sxy_[i] = static_cast<float>(s * sxx + c * sxy);
                                   });
    });
}

/// On return v~ = base velocity - dt div(ahead s) / rho.
void Friction::trial_velocity(const Neighbours& n, double dt) {
    const auto scale = static_cast<float>(dt / discretisation_.density);
    for_each_block(static_cast<int>(n.blocks.size()), threads_, [&](int b) {
        pair_kernels().stress_divergence(pair_rows(n.blocks[b], n), ahead_sxx_.data(), ahead_sxy_.data(),
                                         force_x_.data(), force_y_.data());
        const int last = std::min(n.blocks[b].first_row + rows_per_block, n.soil_count);
        for (int i = n.blocks[b].first_row; i < last; ++i) {
            vx_[i] = base_vx_[i] - scale * force_x_[i];
            vy_[i] = base_vy_[i] - scale * force_y_[i];
        }
    });
}

/// s <- bound(ahead + 2 r e(v~)), then ahead <- s + momentum (s - old s). r = 0.25 rho dl^2 / dt keeps the
/// iteration stable for the lattice's stiffest mode.
void Friction::project(const Neighbours& n, double dt, double momentum) {
    const double step = 0.5 * discretisation_.density * discretisation_.volume() / dt;
    StressUpdate update;
    update.vx = vx_.data();
    update.vy = vy_.data();
    for (int c = 0; c < 4; ++c) update.correction[c] = n.correction[c].data();
    update.strength = strength_.data();
    update.step = static_cast<float>(step);
    update.momentum = static_cast<float>(momentum);
    update.sxx = sxx_.data();
    update.sxy = sxy_.data();
    update.ahead_sxx = ahead_sxx_.data();
    update.ahead_sxy = ahead_sxy_.data();
    for_each_block(static_cast<int>(n.blocks.size()), threads_,
                   [&](int b) { pair_kernels().update_stress(pair_rows(n.blocks[b], n), update); });
    for (int a = 0; a < n.active_count(); ++a) {
        const int i = n.first_boundary + a;
        const VelocityGradient g = boundary_velocity_gradient(n, a, vx_.data(), vy_.data()).corrected(n, i);
        const double trial_xx = ahead_sxx_[i] + step * g.exx();
        const double trial_xy = ahead_sxy_[i] + step * g.exy();
        const double size = std::sqrt(trial_xx * trial_xx + trial_xy * trial_xy);
        const double scale = size > strength_[i] ? strength_[i] / size : 1.0;
        const auto sxx = static_cast<float>(scale * trial_xx);
        const auto sxy = static_cast<float>(scale * trial_xy);
        ahead_sxx_[i] = sxx + update.momentum * (sxx - sxx_[i]);
        ahead_sxy_[i] = sxy + update.momentum * (sxy - sxy_[i]);
        sxx_[i] = sxx;
        sxy_[i] = sxy;
    }
}

/// Eq. 8 from the velocity at hand.
void Friction::yield_from_strain_rate(const Neighbours& n) {
    const auto update = [&](int i, const VelocityGradient& plain) {
        const VelocityGradient g = plain.corrected(n, i);
        const double rate = std::hypot(g.exx(), g.exy());
        const double scale = rate > 0.0 ? strength_[i] / rate : 0.0;
        sxx_[i] = static_cast<float>(scale * g.exx());
        sxy_[i] = static_cast<float>(scale * g.exy());
    };
    for_each_block(static_cast<int>(n.blocks.size()), threads_, [&](int b) {
        for_each_velocity_gradient(n.blocks[b], n, vx_.data(), vy_.data(), update);
    });
    for (int a = 0; a < n.active_count(); ++a) {
        update(n.first_boundary + a, boundary_velocity_gradient(n, a, vx_.data(), vy_.data()));
    }
}

/// On return v* = v^n + dt (g - div s / rho), eq. 3.
void Friction::final_velocity(const Neighbours& n, const Soil& soil, double dt, std::vector<double>& vx,
                              std::vector<double>& vy) {
    const double scale = dt / discretisation_.density;
    vx.assign(n.nodes, 0.0);
    vy.assign(n.nodes, 0.0);
    for_each_block(static_cast<int>(n.blocks.size()), threads_, [&](int b) {
        pair_kernels().stress_divergence(pair_rows(n.blocks[b], n), sxx_.data(), sxy_.data(), force_x_.data(),
                                         force_y_.data());
        const int last = std::min(n.blocks[b].first_row + rows_per_block, n.soil_count);
        for (int i = n.blocks[b].first_row; i < last; ++i) {
            vx[i] = soil.vx[i] - scale * force_x_[i];
            vy[i] = soil.vy[i] - scale * force_y_[i] - dt * gravity_;
        }
    });
}

void Friction::predict(const Neighbours& n, Soil& soil, Wall& wall, double dt, std::vector<double>& vx,
                       std::vector<double>& vy, int iterations) {
    load(n, soil, wall);
    if (scheme_ == FrictionScheme::explicit_) {
        yield_from_strain_rate(n);
    } else {
        apply_pressure(n, soil, dt);
        rotate(n, dt);
        ahead_sxx_ = sxx_;
        ahead_sxy_ = sxy_;
        double t = 1.0;  // Nesterov's sequence
        for (int k = 0; k < (iterations > 0 ? iterations : iterations_); ++k) {
            const double next = 0.5 * (1.0 + std::sqrt(1.0 + 4.0 * t * t));
            trial_velocity(n, dt);
            project(n, dt, (t - 1.0) / next);
            t = next;
        }
    }
    final_velocity(n, soil, dt, vx, vy);
    save(n, soil, wall);
}

}  // namespace runout
