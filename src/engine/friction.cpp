#include "engine/friction.h"

#include <algorithm>
#include <cmath>

#include "engine/operators.h"
#include "engine/parallel.h"

namespace runout {
namespace {

/// Back into the yield circle, eq. 8 as a bound. Pressure never pulls.
void bound_stress(double pressure, double sin_phi, double& sxx, double& sxy) {
    const double strength = std::max(pressure, 0.0) * sin_phi;
    const double size = std::sqrt(sxx * sxx + sxy * sxy);
    if (size <= strength) return;
    const double scale = strength / size;
    sxx *= scale;
    sxy *= scale;
}

}  // namespace

Friction::Friction(const Discretisation& discretisation, const Material& material, const RunSettings& run,
                   int threads)
    : discretisation_(discretisation),
      sin_phi_(std::sin(material.friction_angle)),
      gravity_(run.gravity),
      scheme_(run.friction),
      iterations_(run.friction_iterations),
      threads_(threads) {}

void Friction::load(const Neighbours& n, const Soil& soil, const Wall& wall) {
    for (auto* field : {&pressure_, &sxx_, &sxy_, &old_sxx_, &old_sxy_, &ahead_sxx_, &ahead_sxy_, &base_vx_,
                        &base_vy_, &vx_, &vy_, &force_x_, &force_y_}) {
        field->assign(n.nodes, 0.0);
    }
    for (int i = 0; i < soil.count; ++i) {
        pressure_[i] = soil.pressure[i];
        sxx_[i] = soil.sxx[i];
        sxy_[i] = soil.sxy[i];
        vx_[i] = soil.vx[i];
        vy_[i] = soil.vy[i];
    }
    for (int a = 0; a < n.active_count(); ++a) {
        const int node = n.first_boundary + a;
        pressure_[node] = wall.pressure[n.active[a]];
        sxx_[node] = wall.sxx[n.active[a]];
        sxy_[node] = wall.sxy[n.active[a]];
    }
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
        pair_kernels().pressure_gradient(pair_rows(n.blocks[b], n), pressure_.data(), force_x_.data(),
                                         force_y_.data());
        const int last = std::min(n.blocks[b].first_row + rows_per_block, n.soil_count);
        for (int i = n.blocks[b].first_row; i < last; ++i) {
            base_vx_[i] = soil.vx[i] - scale * force_x_[i];
            base_vy_[i] = soil.vy[i] - scale * force_y_[i] - dt * gravity_;
        }
    });
}

/// The stress turns with the soil (Jaumann); |s| is kept exactly.
void Friction::rotate(const Neighbours& n, double dt) {
    for_each_block(static_cast<int>(n.blocks.size()), threads_, [&](int b) {
        for_each_velocity_gradient(
            n.blocks[b], n, vx_.data(), vy_.data(), [&](int i, const VelocityGradient& plain) {
                const double angle = 2.0 * dt * plain.corrected(&n.correction[4 * i]).spin();
                const double c = std::cos(angle);
                const double s = std::sin(angle);
                const double sxx = sxx_[i];
                sxx_[i] = c * sxx - s * sxy_[i];
                sxy_[i] = s * sxx + c * sxy_[i];
            });
    });
}

/// On return v~ = base velocity - dt div(s) / rho.
void Friction::trial_velocity(const Neighbours& n, const std::vector<double>& sxx,
                              const std::vector<double>& sxy, double dt) {
    const double scale = dt / discretisation_.density;
    for_each_block(static_cast<int>(n.blocks.size()), threads_, [&](int b) {
        pair_kernels().stress_divergence(pair_rows(n.blocks[b], n), sxx.data(), sxy.data(), force_x_.data(),
                                         force_y_.data());
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
    const auto update = [&](int i, const VelocityGradient& plain) {
        const VelocityGradient g = plain.corrected(&n.correction[4 * i]);
        const double old_xx = sxx_[i];
        const double old_xy = sxy_[i];
        sxx_[i] = ahead_sxx_[i] + step * g.exx();
        sxy_[i] = ahead_sxy_[i] + step * g.exy();
        bound_stress(pressure_[i], sin_phi_, sxx_[i], sxy_[i]);
        ahead_sxx_[i] = sxx_[i] + momentum * (sxx_[i] - old_xx);
        ahead_sxy_[i] = sxy_[i] + momentum * (sxy_[i] - old_xy);
    };
    for_each_block(static_cast<int>(n.blocks.size()), threads_, [&](int b) {
        for_each_velocity_gradient(n.blocks[b], n, vx_.data(), vy_.data(), update);
    });
    for (int a = 0; a < n.active_count(); ++a) {
        update(n.first_boundary + a, boundary_velocity_gradient(n, a, vx_.data(), vy_.data()));
    }
}

/// Eq. 8 from the velocity at hand.
void Friction::yield_from_strain_rate(const Neighbours& n) {
    const auto update = [&](int i, const VelocityGradient& plain) {
        const VelocityGradient g = plain.corrected(&n.correction[4 * i]);
        const double rate = std::hypot(g.exx(), g.exy());
        const double scale = rate > 0.0 ? std::max(pressure_[i], 0.0) * sin_phi_ / rate : 0.0;
        sxx_[i] = scale * g.exx();
        sxy_[i] = scale * g.exy();
    };
    for_each_block(static_cast<int>(n.blocks.size()), threads_, [&](int b) {
        for_each_velocity_gradient(n.blocks[b], n, vx_.data(), vy_.data(), update);
    });
    for (int a = 0; a < n.active_count(); ++a) {
        update(n.first_boundary + a, boundary_velocity_gradient(n, a, vx_.data(), vy_.data()));
    }
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
            trial_velocity(n, ahead_sxx_, ahead_sxy_, dt);
            project(n, dt, (t - 1.0) / next);
            t = next;
        }
    }
    for (int i = 0; i < soil.count; ++i) {
        base_vx_[i] = soil.vx[i];
        base_vy_[i] = soil.vy[i] - dt * gravity_;
    }
    trial_velocity(n, sxx_, sxy_, dt);
    vx = vx_;
    vy = vy_;
    save(n, soil, wall);
}

}  // namespace runout
