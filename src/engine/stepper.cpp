#include "engine/stepper.h"

#include <algorithm>
#include <cmath>
#include <thread>

#include "engine/pairs/operators.h"
#include "engine/pairs/row_passes.h"
#include "engine/particles/fine_detail.h"
#include "engine/threads/node_array.h"

namespace runout {
namespace {

constexpr int particles_per_thread = 1500;     // below this a second thread costs more than it brings
constexpr double pressure_wave_courant = 0.5;  // dt <= 0.5 dl / sqrt(p_max / rho), see choose_time_step
// At most this many spacings for the fall within a step, see choose_time_step.
constexpr double falling_courant = 0.03;
constexpr double sleep_window = 0.25;  // in sqrt(sqrt(S)/g)
constexpr int equilibrium_iterations = 20;
constexpr double no_pressure = 1e-6;  // of rho g sqrt(S); less counts as none
// Excess of density, or its gain in sqrt(sqrt(S)/g); less counts as none.
constexpr double no_compression = 1e-3;

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

double highest(const std::vector<Vec2>& points) {
    double y = points.front().y();
    for (const Vec2& p : points) y = std::max(y, p.y());
    return y;
}

double leftmost(const std::vector<Vec2>& points) {
    double x = points.front().x();
    for (const Vec2& p : points) x = std::min(x, p.x());
    return x;
}

/// Time limit, s. A mass that slides on with the speed of its fall H needs sqrt(2 H/g) / strength to stop on
/// level ground. On a bed close to repose it takes many times as long, hence the factors.
double time_to_stop(double height, double gravity, double strength) {
    return std::max(60.0, 20.0 / std::max(strength, 0.01)) * std::sqrt(height / gravity);
}

double time_limit_of(const Problem& problem, double height) {
    const SolverSettings& settings = problem.settings;
    return settings.time_limit > 0
               ? settings.time_limit
               : time_to_stop(height, settings.gravity, least_strength(problem.material, problem.effects));
}

ProblemScales scales_of(const Problem& problem, const EffectSet& effects) {
    const double length = std::sqrt(problem.mass.area);
    const double floor = lowest(effects.bed_under(problem.mass.ground));
    return {length, std::sqrt(length / problem.settings.gravity), floor,
            highest(problem.mass.outline) - floor};
}

/// All soil and the bed. The mass has the first numbers, the layer of an erodible bed those that follow.
ParticleSystem particles_at_release(const Packing& packing, const Polyline& ground, EffectSet& effects) {
    ParticleSystem particles;
    particles.soil = soil_at(packing.points);
    particles.wall = effects.wall_under(ground);
    append_soil(particles.soil, effects.layer_soil(ground, particles.soil.count));
    return particles;
}

std::vector<Vec2> positions_of(const Soil& soil) {
    std::vector<Vec2> points;
    for (int i = 0; i < soil.count; ++i) points.emplace_back(soil.x[i], soil.y[i]);
    return points;
}

}  // namespace

Stepper::Stepper(const Problem& problem, const Packing& packing)
    : threads_(threads_for(problem.settings.threads, packing.points.size())),
      settings_(problem.settings),
      discretisation_(
          make_discretisation(packing.spacing, problem.settings.smoothing_ratio, problem.material.density)),
      effects_(problem, discretisation_),
      ground_(problem.mass.ground),
      scales_(scales_of(problem, effects_)),
      particles_(particles_at_release(packing, met_ground(problem.mass.ground), effects_)),
      starts_(positions_of(particles_.soil)),
      search_(discretisation_, threads_),
      friction_(discretisation_, effects_.yield_strength(particles_.wall), settings_.friction,
                settings_.friction_iterations),
      pressure_(discretisation_, settings_.gravity, scales_.length, settings_.pressure_tolerance),
      guard_(discretisation_, settings_.gravity),
      release_(problem.effects.release.value_or(StagedRelease{}),
               leftmost(packing.points) - 0.5 * packing.spacing),
      equilibrium_(starts_.size(), settings_.gravity),
      invariants_({settings_.gravity, scales_.height, discretisation_.spacing, discretisation_.density,
                   settings_.courant, effects_.tension()}),
      ending_(settings_.gravity, scales_.length, discretisation_.spacing,
              time_limit_of(problem, scales_.height)) {
    if (effects_.cohesive()) pressure_.bear_tension(effects_.tension());
    ending_.start(particles_.soil, 0.0);
    if (settings_.sleeping && settings_.friction == FrictionScheme::projected) {
        sleep_.emplace(discretisation_, settings_.gravity, sleep_window * scales_.time, threads_);
        sleep_->wake_all(particles_.soil, 0.0);
    }
    make_room();
    search_.sort(particles_.soil);
    search_.find(particles_.soil, particles_.wall, particles_.neighbours);
    effects_.start(met_ground(ground_.points()), particles_, starts_);
}

/// The ground as the particles can meet it. Thickness and run-out count from the ground as it is.
Polyline Stepper::met_ground(const Polyline& ground) const {
    return without_fine_detail(ground, discretisation_.spacing);
}

void Stepper::make_room() {
    for (auto* field : {&predicted_.x, &predicted_.y, &pressure_gradient_.x, &pressure_gradient_.y})
        field->assign(particles_.soil.padded(), 0.0);
}

void Stepper::step() {
    if (!equilibrium_.reached()) return balance();
    let_go_what_is_due();
    find_neighbours();
    const double dt = choose_time_step();
    const PressureSolve solve = in_free_flight() ? fly(dt) : predict_and_project(dt);
    clock_.enter(Phase::motion);
    correct(dt);
    effects_.damp(particles_, dt, ledger_);
    move(dt);
    effects_.shift(particles_, dt, ledger_);
    StepFacts facts = guard_.put_back(particles_, pressure_.node_pressure(), dt, effects_, ledger_);
    effects_.observe(particles_, starts_, dt);
    count(dt, solve);
    judge(facts, dt);
    clock_.leave();
}

/// One round towards the state at release: pressure and stress in balance with gravity, the particles not
/// moving. Without it the first moments of every run are wrong, and so are cases close to stability.
void Stepper::balance() {
    const double dt = 0.1 * discretisation_.spacing / std::sqrt(settings_.gravity * scales_.length);
    clock_.enter(Phase::equilibrium);
    friction_.predict(particles_,
                      {.dt = dt,
                       .body = effects_.body_acceleration(time_),
                       .iterations = equilibrium_iterations,
                       .pore_pressure = effects_.pore_pressure(particles_, time_)},
                      predicted_, pressure_gradient_);
    highest_pressure_ =
        pressure_.solve(particles_, predicted_, {dt, 1.0, false, 1.0}, pressure_gradient_).highest;
    for (int i = 0; i < particles_.soil.count; ++i)
        equilibrium_.observe(i, predicted_.x[i] / dt - pressure_gradient_.x[i] / discretisation_.density,
                             predicted_.y[i] / dt - pressure_gradient_.y[i] / discretisation_.density);
    clock_.leave();
    equilibrium_.end_round();
}

/// Adds the next layer or mass of a staged release, free of stress as in free fall.
void Stepper::let_go_what_is_due() {
    if (release_.stage_ended()) {
        const Release::Layer layer =
            release_.next_layer(particles_.soil, particles_.wall.bed_line, discretisation_.spacing);
        scales_.height = std::max(scales_.height, layer.top - scales_.floor);
        add_soil(layer.points);
    }
    if (const LaterMass* later = release_.mass_due(time_)) let_go_mass(later->mass);
}

/// Adds the mass, and changes the bed to what it leaves.
void Stepper::let_go_mass(const Mass& mass) {
    Wall& wall = particles_.wall;
    ground_ = BedLine(mass.ground);
    wall = effects_.wall_under(met_ground(mass.ground));
    pressure_.forget_wall();
    friction_.set_yield(effects_.yield_strength(wall));
    effects_.take_new_wall(wall);
    const std::vector<Vec2> points =
        place_mass(mass, particles_.soil, discretisation_.spacing, settings_.smoothing_ratio);
    scales_.height = std::max(scales_.height, highest(points) - scales_.floor);
    add_soil(points);
    if (sleep_) sleep_->wake_all(particles_.soil, time_);
}

/// Adds soil at rest, m. Rest and energy are judged anew from here.
void Stepper::add_soil(const std::vector<Vec2>& points) {
    append_soil(particles_.soil, points);
    starts_.insert(starts_.end(), points.begin(), points.end());
    effects_.take_in(points);
    make_room();
    release_.begin_stage();
    ending_.start(particles_.soil, time_);
    if (sleep_) sleep_->append(particles_.soil);
    invariants_.restart(scales_.height);
}

void Stepper::find_neighbours() {
    clock_.enter(Phase::neighbours);
    Wall& wall = particles_.wall;
    Neighbours& n = particles_.neighbours;
    search_.sort(particles_.soil);
    const int sleeping = sleep_ ? sleep_->find_sleeping(particles_.soil, n.asleep) : 0;
    search_.find(particles_.soil, wall, n);
    if (sleeping > 0) let_sleep(sleeping);
    for (const int b : n.left) wall.pressure[b] = wall.sxx[b] = wall.sxy[b] = 0.0;
}

/// Sets velocity and pressure gradient of sleeping soil to 0. The energy that it trembled with is booked.
void Stepper::let_sleep(int sleeping) {
    Soil& soil = particles_.soil;
    Neighbours& n = particles_.neighbours;
    ledger_.counts.sleeping_particle_steps += sleeping;
    double trembling = 0.0;
    for (int i = 0; i < soil.count; ++i) {
        if (!n.is_asleep(i)) continue;
        trembling += 0.5 * (soil.vx[i] * soil.vx[i] + soil.vy[i] * soil.vy[i]);
        soil.vx[i] = soil.vy[i] = 0.0;
        n.density[i] = sleep_->density(soil.id[i]);
        pressure_gradient_.x[i] = pressure_gradient_.y[i] = 0.0;
    }
    ledger_.numerical += discretisation_.mass() * trembling;
}

/// The least of three limits, s:
/// - the Courant step of eq. 6. Lone grains may go a whole spacing, since flight needs no small steps; so
///   they do not set the step of all;
/// - the same for the speed that gravity adds within the step, and less than films of grains can bear: they
///   tremble when they fall further in a step;
/// - the passage of a pressure wave. The lattice of particles answers a change of pressure explicitly, and
///   without this limit a pile at rest fluidises.
/// Shorter where the run nears a limit of the checks.
double Stepper::choose_time_step() {
    const Soil& soil = particles_.soil;
    const Neighbours& n = particles_.neighbours;
    const double lone2 = settings_.courant * settings_.courant;
    const double speed2 = max_chunks(n.chunks, scratch_.greatest, [&](int chunk) {
        double greatest = 0.0;
        for_each_soil(n, chunk, [&](int i) {
            const double v2 = soil.vx[i] * soil.vx[i] + soil.vy[i] * soil.vy[i];
            greatest = std::max(greatest, n.density[i] >= body_density ? v2 : lone2 * v2);
        });
        return greatest;
    });
    const double dl = discretisation_.spacing;
    double dt = std::sqrt(std::min(settings_.courant, falling_courant) * dl /
                          effects_.body_acceleration(time_).norm());
    if (speed2 > 0.0) dt = std::min(dt, settings_.courant * dl / std::sqrt(speed2));
    if (highest_pressure_ > 0.0) {
        dt =
            std::min(dt, pressure_wave_courant * dl / std::sqrt(highest_pressure_ / discretisation_.density));
    }
    return invariants_.pace() * dt;
}

/// Whether nothing touches the bed, bears pressure or is being compressed: friction and pressure are then
/// both 0. Never for cohesive soil, which holds together by itself.
bool Stepper::in_free_flight() {
    const Neighbours& n = particles_.neighbours;
    const double weight = discretisation_.density * settings_.gravity * scales_.length;
    if (!n.active.empty() || highest_pressure_ > no_pressure * weight) return false;
    if (effects_.cohesive()) return false;
    soil_velocities(n, particles_.soil, scratch_.flight_velocity);
    std::vector<double>& divergence = scratch_.flight_divergence;
    set_all(divergence, n.nodes, 0.0);
    for (const PairBlock& block : n.blocks)
        pair_kernels().velocity_divergence(pair_rows(block, n), scratch_.flight_velocity.data(),
                                           divergence.data());
    for (int i = 0; i < n.soil_count; ++i)
        if (n.density[i] - 1.0 > no_compression || -divergence[i] * scales_.time > no_compression)
            return false;
    return true;
}

/// As `predict_and_project`, in free flight.
PressureSolve Stepper::fly(double dt) {
    Soil& soil = particles_.soil;
    const Vec2 gain = dt * effects_.body_acceleration(time_);
    set_all(predicted_.x, particles_.neighbours.nodes, 0.0);
    set_all(predicted_.y, particles_.neighbours.nodes, 0.0);
    for (int i = 0; i < soil.count; ++i) {
        predicted_.x[i] = soil.vx[i] + gain.x();
        predicted_.y[i] = soil.vy[i] + gain.y();
    }
    for (auto* field : {&soil.pressure, &soil.sxx, &soil.sxy, &pressure_gradient_.x, &pressure_gradient_.y})
        std::fill(field->begin(), field->end(), 0.0);
    ledger_.counts.flying_particle_steps += soil.count;
    return {.converged = true};
}

/// Friction and pressure. On return `predicted_` and `pressure_gradient_` are those that `correct` needs.
PressureSolve Stepper::predict_and_project(double dt) {
    clock_.enter(Phase::friction);
    friction_.predict(particles_,
                      {.dt = dt,
                       .body = effects_.body_acceleration(time_),
                       .pore_pressure = effects_.pore_pressure(particles_, time_)},
                      predicted_, pressure_gradient_);
    clock_.enter(Phase::pressure);
    return pressure_.solve(particles_, predicted_, {.dt = dt}, pressure_gradient_);
}

/// Eq. 4: the velocity becomes that of the end of the step. The work of friction and pressure is booked.
void Stepper::correct(double dt) {
    Soil& soil = particles_.soil;
    const Neighbours& n = particles_.neighbours;
    const double gravity = settings_.gravity;
    const double scale = dt / discretisation_.density;
    const Vec2 gain = dt * effects_.body_acceleration(time_);
    const auto update = [&](int chunk) {
        StepWork work;
        for_each_soil(n, chunk, [&](int i) {
            const double px = -scale * pressure_gradient_.x[i];
            const double py = -scale * pressure_gradient_.y[i];
            const double fx = predicted_.x[i] - soil.vx[i] - gain.x();
            const double fy = predicted_.y[i] - soil.vy[i] - gain.y();
            const double vx = predicted_.x[i] + px;
            const double vy = predicted_.y[i] + py;
            const double mean_x = 0.5 * (vx + soil.vx[i]);
            const double mean_y = 0.5 * (vy + soil.vy[i]);
            work.friction -= fx * mean_x + fy * mean_y;
            work.pressure += px * mean_x + py * mean_y;
            work.integration += dt * gravity * (mean_y - vy);
            work.momentum_x += mean_x;
            work.momentum_y += mean_y;
            soil.vx[i] = vx;
            soil.vy[i] = vy;
        });
        return work;
    };
    const StepWork work = sum_chunks(n.chunks, scratch_.work, update);
    ledger_.friction += discretisation_.mass() * work.friction;
    ledger_.pressure += discretisation_.mass() * work.pressure;
    ledger_.numerical += discretisation_.mass() * work.integration;
    // Work of the body force less that of gravity, which counts as potential energy: what the ground's motion
    // gives.
    ledger_.shaking +=
        discretisation_.mass() * (gain.x() * work.momentum_x + (gain.y() + dt * gravity) * work.momentum_y);
}

/// x += dt v^{n+1}. With the mean of old and new velocity a pile collapses.
void Stepper::move(double dt) {
    Soil& soil = particles_.soil;
    const Neighbours& n = particles_.neighbours;
    const double highest = max_chunks(n.chunks, scratch_.greatest, [&](int chunk) {
        double density = 0.0;
        for_each_soil(n, chunk, [&](int i) {
            soil.x[i] += dt * soil.vx[i];
            soil.y[i] += dt * soil.vy[i];
            density = std::max(density, n.density[i]);
        });
        return density;
    });
    ledger_.counts.highest_density = std::max(ledger_.counts.highest_density, highest);
}

void Stepper::count(double dt, const PressureSolve& solve) {
    highest_pressure_ = solve.highest;
    time_ += dt;
    unconverged_in_a_row_ = solve.converged ? 0 : unconverged_in_a_row_ + 1;
    WorkCounts& counts = ledger_.counts;
    ++counts.steps;
    counts.particle_steps += particles_.soil.count;
    counts.pressure_iterations += solve.iterations;
    counts.unconverged_solves += solve.converged ? 0 : 1;
}

/// Ends the run at rest, at the time limit, or with the name of what went wrong; lets soil fall asleep.
void Stepper::judge(StepFacts& facts, double dt) {
    clock_.enter(Phase::judgement);
    const Soil& soil = particles_.soil;
    const Neighbours& n = particles_.neighbours;
    const double mass = discretisation_.mass() * soil.count;
    facts.time = time_;
    facts.dt = dt;
    facts.unconverged = unconverged_in_a_row_;
    facts.work_done = ledger_.taken() / mass;
    facts.work_supplied = ledger_.shaking / mass;
    const SoilSurvey all = sum_chunks(n.chunks, scratch_.survey, [&](int chunk) {
        const RowRange rows = soil_rows(n, chunk);
        return survey(soil, n.density, settings_.gravity, rows.first, rows.last);
    });
    invariants_.observe(all, facts);
    ending_.judge(all, invariants_, particles_.wall.bed_line, time_);
    if (!ending_.at_rest(soil, time_))
        ending_.judge_time(time_);
    else if (!effects_.act_at(time_) && !release_.goes_on(time_))
        end_at_rest();
    if (sleep_ && !effects_.act_at(time_)) sleep_->observe(soil, n.density, time_);
}

StateView Stepper::state() const {
    const Soil& soil = particles_.soil;
    const auto count = static_cast<std::size_t>(soil.count);
    const auto view = [&](const std::vector<double>& field) { return std::span(field).first(count); };
    return {time_,
            &discretisation_,
            &particles_.wall.bed_line,
            &ground_,
            settings_.gravity,
            view(soil.x),
            view(soil.y),
            view(soil.vx),
            view(soil.vy),
            view(soil.pressure),
            view(soil.sxx),
            view(soil.sxy),
            view(particles_.neighbours.density),
            std::span(soil.id).first(count),
            effects_.unmoved_layer()};
}

EnergyBudget Stepper::energy() const {
    const Soil& soil = particles_.soil;
    EnergyBudget budget{
        0, 0, ledger_.friction, ledger_.pressure, ledger_.guard, ledger_.shaking, ledger_.side_walls};
    for (int i = 0; i < soil.count; ++i) {
        budget.kinetic += 0.5 * (soil.vx[i] * soil.vx[i] + soil.vy[i] * soil.vy[i]);
        budget.potential += settings_.gravity * soil.y[i];
    }
    budget.kinetic *= discretisation_.mass();
    budget.potential *= discretisation_.mass();
    return budget;
}

}  // namespace runout
