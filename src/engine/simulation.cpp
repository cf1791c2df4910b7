#include "engine/simulation.h"

#include <algorithm>
#include <cmath>
#include <thread>

#include "engine/effects/bed_shape.h"
#include "engine/pairs/operators.h"
#include "engine/threads/node_array.h"
#include "engine/threads/row_passes.h"
#include "scene/rest_check.h"

namespace runout {
namespace {

constexpr int particles_per_thread = 1500;     // below this a second thread costs more than it brings
constexpr double pressure_wave_courant = 0.5;  // dt <= 0.5 dl / sqrt(p_max / rho), see choose_time_step
constexpr double falling_courant = 0.03;       // spacings that soil at rest may fall in a step, see there
constexpr double sleep_window = 0.25;          // in sqrt(sqrt(S)/g)
constexpr int equilibrium_rounds = 200;
constexpr int equilibrium_iterations = 20;
constexpr double equilibrium_change = 5e-4;  // of the acceleration between two rounds, in g, root mean square

int threads_for(int wanted, std::size_t particles) {
    const int available =
        wanted > 0 ? wanted : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    return std::clamp(static_cast<int>(particles) / particles_per_thread, 1, available);
}

double lowest(const Polyline& points) {
    double y = points.front().y();
    for (const Vec2& p : points) y = std::min(y, p.y());
    return y;
}

double highest(const Polygon& points) {
    double y = points.front().y();
    for (const Vec2& p : points) y = std::max(y, p.y());
    return y;
}

/// A mass that slides on with the speed of its fall H needs sqrt(2 H/g) / strength to stop on level ground;
/// on a bed close to repose it takes many times as long.
double time_to_stop(double height, double gravity, double strength) {
    return std::max(60.0, 20.0 / std::max(strength, 0.01)) * std::sqrt(height / gravity);
}

double spacing_of(const Scene& scene) {
    return scene.run.particle_spacing > 0 ? scene.run.particle_spacing
                                          : std::sqrt(scene.source.area) / scene.run.resolution;
}

}  // namespace

Simulation::Simulation(const Scene& scene)
    : Simulation(scene, pack_source(scene.source, spacing_of(scene), scene.run.smoothing_ratio,
                                    scene.run.lattice_seed)) {}

Simulation::Simulation(const Scene& scene, const Packing& packing)
    : threads_(threads_for(scene.run.threads, packing.x.size())),
      run_(scene.run),
      material_(scene.material),
      effects_(with_whole_layers(scene.effects, packing.spacing)),
      release_(scene.effects.release.value_or(StagedRelease{})),
      ground_(scene.source.bed),
      bed_(shape_bed(scene.source.bed, effects_)),
      discretisation_(
          make_discretisation(packing.spacing, scene.run.smoothing_ratio, scene.material.density)),
      length_scale_(std::sqrt(scene.source.area)),
      time_scale_(std::sqrt(length_scale_ / scene.run.gravity)),
      floor_(lowest(bed_.points())),
      height_(highest(scene.source.outline) - floor_),
      time_limit_(scene.run.time_limit > 0
                      ? scene.run.time_limit
                      : time_to_stop(height_, run_.gravity, least_strength(material_, effects_))),
      invariants_({run_.gravity, height_, discretisation_.spacing, discretisation_.density, run_.courant,
                   tension_cut_off(material_, effects_)}),
      rest_(run_.gravity, length_scale_, discretisation_.spacing),
      soil_(soil_at(packing.x, packing.y)),
      wall_(make_wall(bed_, discretisation_)),
      search_(discretisation_, threads_),
      friction_(discretisation_,
                YieldStrength(scene.material, scene.effects,
                              base_strength_ratios(scene.material, scene.effects, wall_)),
                run_.friction, run_.friction_iterations),
      pressure_(discretisation_, scene.run.gravity, length_scale_, scene.run.pressure_tolerance) {
    for (std::size_t i = 0; i < packing.x.size(); ++i) start_.emplace_back(packing.x[i], packing.y[i]);
    release_head_ = *std::min_element(packing.x.begin(), packing.x.end()) - 0.5 * packing.spacing;
    set_up_effects();
    rest_.start(soil_, 0.0);
    if (run_.sleeping && run_.friction == FrictionScheme::projected) {
        sleep_.emplace(discretisation_, run_.gravity, sleep_window * time_scale_, threads_);
        sleep_->wake_all(soil_, 0.0);
    }
    make_room();
    release_ax_.assign(soil_.count, 0.0);
    release_ay_.assign(soil_.count, 0.0);
    search_.sort(soil_);
    search_.find(soil_, wall_, neighbours_);
    if (effects_.erodible_bed) note_moved_layer();
}

void Simulation::make_room() {
    for (auto* field : {&predicted_vx_, &predicted_vy_, &force_x_, &force_y_})
        field->assign(soil_.padded(), 0.0);
}

/// One round towards pressure and stress in balance on the frozen geometry, the mass not yet moving. Without
/// it the first moments of every run, and cases close to stability, are wrong. Ends when the acceleration at
/// release no longer changes; then the mass is released.
void Simulation::balance() {
    const double dt = 0.1 * discretisation_.spacing / std::sqrt(run_.gravity * length_scale_);
    clock_.enter(Phase::equilibrium);
    friction_.predict(neighbours_, soil_, wall_, friction_step(dt, equilibrium_iterations), predicted_vx_,
                      predicted_vy_);
    highest_pressure_ =
        pressure_.solve(neighbours_, soil_, wall_, predicted_vx_, predicted_vy_, {dt, 1.0, false, 1.0})
            .highest;
    find_pressure_gradient();
    double change2 = 0.0;
    for (int i = 0; i < soil_.count; ++i) {
        const double ax = predicted_vx_[i] / dt - force_x_[i] / discretisation_.density;
        const double ay = predicted_vy_[i] / dt - force_y_[i] / discretisation_.density;
        change2 +=
            (ax - release_ax_[i]) * (ax - release_ax_[i]) + (ay - release_ay_[i]) * (ay - release_ay_[i]);
        release_ax_[i] = ax;
        release_ay_[i] = ay;
    }
    clock_.leave();
    ++balance_rounds_;
    const bool unchanged = std::sqrt(change2 / soil_.count) < equilibrium_change * run_.gravity;
    released_ = unchanged || balance_rounds_ >= equilibrium_rounds;
}

void Simulation::step() {
    if (!released_) return balance();
    if (stage_ended_) release_layer();
    if (masses_released_ < release_.masses.size() && time_ >= release_.masses[masses_released_].time)
        release_mass();
    clock_.enter(Phase::neighbours);
    search_.sort(soil_);
    const int resting = sleep_ ? sleep_->find_resting(soil_, neighbours_.resting) : 0;
    search_.find(soil_, wall_, neighbours_);
    if (resting > 0) let_sleep(resting);
    for (const int b : neighbours_.left) wall_.pressure[b] = wall_.sxx[b] = wall_.sxy[b] = 0.0;
    const double dt = choose_time_step();
    const PressureSolve solve = in_free_flight() ? fly(dt) : resist(dt);
    clock_.enter(Phase::motion);
    correct(dt);
    if (filter_ || effects_.side_walls) damp(dt);
    move(dt);
    if (friction_.yield().cohesive()) even_out(dt);
    StepFacts facts = guard_wall(dt);
    if (barrier_) measure_barrier(dt);
    if (effects_.erodible_bed) note_moved_layer();
    highest_pressure_ = solve.highest;

    time_ += dt;
    ++work_.steps;
    work_.particle_steps += soil_.count;
    work_.pressure_iterations += solve.iterations;
    unconverged_in_a_row_ = solve.converged ? 0 : unconverged_in_a_row_ + 1;
    work_.unconverged_solves += solve.converged ? 0 : 1;
    clock_.enter(Phase::judgement);
    facts.dt = dt;
    facts.unconverged = unconverged_in_a_row_;
    judge(facts);
    if (sleep_) watch_sleep();
    clock_.leave();
}

/// Friction and pressure. On return the predicted velocity and the pressure gradient are there for the
/// corrector.
PressureSolve Simulation::resist(double dt) {
    clock_.enter(Phase::friction);
    friction_.predict(neighbours_, soil_, wall_, friction_step(dt), predicted_vx_, predicted_vy_);
    clock_.enter(Phase::pressure);
    const PressureSolve solve =
        pressure_.solve(neighbours_, soil_, wall_, predicted_vx_, predicted_vy_, {.dt = dt});
    find_pressure_gradient();
    return solve;
}

/// The least of three limits: the Courant step of eq. 6; the same for the speed that gravity adds within the
/// step, and never more than films of grains stand, which tremble when they fall further in a step; and the
/// passage of a pressure wave, since the lattice of particles answers a change of pressure explicitly:
/// without this one a pile at rest fluidises. Lone grains, whose flight takes no small steps, do not set the
/// pace for all: they may go a whole spacing. Shorter where the run nears a limit of the checks.
double Simulation::choose_time_step() {
    const double lone2 = run_.courant * run_.courant;
    const double speed2 = max_chunks(neighbours_.chunks, partial_, [&](int chunk) {
        double greatest = 0.0;
        for_each_soil(neighbours_, chunk, [&](int i) {
            const double v2 = soil_.vx[i] * soil_.vx[i] + soil_.vy[i] * soil_.vy[i];
            greatest = std::max(greatest, in_body(i) ? v2 : lone2 * v2);
        });
        return greatest;
    });
    const double dl = discretisation_.spacing;
    double dt = std::sqrt(std::min(run_.courant, falling_courant) * dl / body_acceleration().norm());
    if (speed2 > 0.0) dt = std::min(dt, run_.courant * dl / std::sqrt(speed2));
    if (highest_pressure_ > 0.0) {
        dt =
            std::min(dt, pressure_wave_courant * dl / std::sqrt(highest_pressure_ / discretisation_.density));
    }
    return invariants_.pace() * dt;
}

FrictionStep Simulation::friction_step(double dt, int iterations) {
    FrictionStep step{.dt = dt, .body = body_acceleration(), .iterations = iterations, .bed = &bed_};
    if (pore_water_) {
        const Stopwatch watch(cost_of("pore_pressure"));
        pore_water_->find(neighbours_, soil_, wall_, bed_, time_, pore_pressure_);
        step.pore_pressure = &pore_pressure_;
    }
    return step;
}

void Simulation::find_pressure_gradient() {
    for_each_chunk(neighbours_.chunks, [&](int chunk) {
        for_each_awake(neighbours_, chunk, [&](const PairRows& rows, int) {
            pair_kernels().pressure_gradient(rows, pressure_.node_pressure().data(), force_x_.data(),
                                             force_y_.data());
        });
    });
}

/// Eq. 4. On return the velocity is that of the end of the step, and the work of friction and pressure is
/// booked.
void Simulation::correct(double dt) {
    const double scale = dt / discretisation_.density;
    const Vec2 gain = dt * body_acceleration();
    const auto update = [&](int chunk) {
        StepWork work;
        for_each_soil(neighbours_, chunk, [&](int i) {
            const double px = -scale * force_x_[i];
            const double py = -scale * force_y_[i];
            const double fx = predicted_vx_[i] - soil_.vx[i] - gain.x();
            const double fy = predicted_vy_[i] - soil_.vy[i] - gain.y();
            const double vx = predicted_vx_[i] + px;
            const double vy = predicted_vy_[i] + py;
            const double mean_x = 0.5 * (vx + soil_.vx[i]);
            const double mean_y = 0.5 * (vy + soil_.vy[i]);
            work.friction -= fx * mean_x + fy * mean_y;
            work.pressure += px * mean_x + py * mean_y;
            work.integration += dt * run_.gravity * (mean_y - vy);
            work.momentum_x += mean_x;
            work.momentum_y += mean_y;
            soil_.vx[i] = vx;
            soil_.vy[i] = vy;
        });
        return work;
    };
    const StepWork work = sum_chunks(neighbours_.chunks, partial_work_, update);
    friction_work_ += discretisation_.mass() * work.friction;
    pressure_work_ += discretisation_.mass() * work.pressure;
    numerical_work_ += discretisation_.mass() * work.integration;
    // What gravity gives is potential energy; what the ground's motion gives comes on top.
    shaking_work_ += discretisation_.mass() *
                     (gain.x() * work.momentum_x + (gain.y() + dt * run_.gravity) * work.momentum_y);
}

/// x += dt v^{n+1}: the mean of old and new velocity collapses the pile.
void Simulation::move(double dt) {
    const double highest = max_chunks(neighbours_.chunks, partial_, [&](int chunk) {
        double density = 0.0;
        for_each_soil(neighbours_, chunk, [&](int i) {
            soil_.x[i] += dt * soil_.vx[i];
            soil_.y[i] += dt * soil_.vy[i];
            density = std::max(density, neighbours_.density[i]);
        });
        return density;
    });
    work_.highest_density = std::max(work_.highest_density, highest);
}

StateView Simulation::state() const {
    const auto count = static_cast<std::size_t>(soil_.count);
    const auto view = [&](const std::vector<double>& field) { return std::span(field).first(count); };
    return {time_,
            &discretisation_,
            &bed_,
            &ground_,
            run_.gravity,
            view(soil_.x),
            view(soil_.y),
            view(soil_.vx),
            view(soil_.vy),
            view(soil_.pressure),
            view(soil_.sxx),
            view(soil_.sxy),
            view(neighbours_.density),
            std::span(soil_.id).first(count),
            std::span(resting_layer_)};
}

Vec2 Simulation::bed_force() const {
    Vec2 force{0, 0};
    for (const PairBlock& block : neighbours_.blocks) {
        for (const WallPair& pair : block.wall_pairs) {
            const double p = soil_.pressure[pair.row] + wall_.pressure[pair.boundary];
            const double sxx = soil_.sxx[pair.row] + wall_.sxx[pair.boundary];
            const double sxy = soil_.sxy[pair.row] + wall_.sxy[pair.boundary];
            force += Vec2{(p + sxx) * pair.gx + sxy * pair.gy, sxy * pair.gx + (p - sxx) * pair.gy};
        }
    }
    return discretisation_.volume() * force;
}

EnergyBudget Simulation::energy() const {
    EnergyBudget budget{0, 0, friction_work_, pressure_work_, guard_work_, shaking_work_, side_wall_work_};
    for (int i = 0; i < soil_.count; ++i) {
        budget.kinetic += 0.5 * (soil_.vx[i] * soil_.vx[i] + soil_.vy[i] * soil_.vy[i]);
        budget.potential += run_.gravity * soil_.y[i];
    }
    budget.kinetic *= discretisation_.mass();
    budget.potential *= discretisation_.mass();
    return budget;
}

}  // namespace runout
