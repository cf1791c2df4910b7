// The hooks of the simulation for effects that a case names; see docs/effects.md. None is called unless its
// effect is there.

#include <algorithm>
#include <cmath>
#include <string_view>

#include "engine/effects/bed_shape.h"
#include "engine/effects/later_masses.h"
#include "engine/effects/side_walls.h"
#include "engine/pairs/operators.h"
#include "engine/particles/packing.h"
#include "engine/simulation.h"

namespace runout {
namespace {

constexpr double shifting = 0.1;        // of the way to even spacing in a step
constexpr double most_shifting = 0.02;  // spacings a step
constexpr double shifting_way = 0.8;    // of the way that the particle has moved in the step
// Shares of the velocity filter. With the lesser one a cut near its limit slowly comes apart; with the
// greater one Bagnold's profile is off by 3.0 % in place of 2.7.
constexpr double standing_filter = 0.5;
constexpr double flowing_filter = 0.25;
constexpr double moved_spacings = 2.0;  // that soil of the bed must move to count as debris

}  // namespace

void Simulation::set_up_effects() {
    const bool cohesive = friction_.yield().cohesive();
    if (cohesive) pressure_.bear_tension(tension_cut_off(material_, effects_));
    if (cohesive || (effects_.rate && effects_.rate->increase != 0.0))
        filter_.emplace(discretisation_, cohesive ? standing_filter : flowing_filter);
    if (effects_.erodible_bed) {
        Source layer;
        layer.outline = layer_outline(ground_.points(), *effects_.erodible_bed);
        layer.bed = bed_.points();
        layer.area = polygon_area(layer.outline);
        const Packing packing = pack_source(layer, discretisation_.spacing, run_.smoothing_ratio);
        std::vector<Vec2> points;
        for (std::size_t i = 0; i < packing.x.size(); ++i) points.emplace_back(packing.x[i], packing.y[i]);
        first_layer_id_ = soil_.count;
        end_layer_id_ = first_layer_id_ + static_cast<int>(points.size());
        append_soil(soil_, points);
        start_.insert(start_.end(), points.begin(), points.end());
        layer_moved_.assign(points.size(), 0);
    }
    if (effects_.pore_pressure)
        pore_water_.emplace(*effects_.pore_pressure, discretisation_, run_.gravity, start_);
    if (effects_.shaking) ground_motion_.emplace(*effects_.shaking);
    if (effects_.barrier) {
        Effects others = effects_;
        others.barrier.reset();
        barrier_.emplace(barrier_outline(shape_bed(ground_.points(), others), *effects_.barrier), bed_, wall_,
                         discretisation_);
    }
}

double& Simulation::cost_of(const char* effect) {
    for (EffectCost& cost : effect_costs_)
        if (std::string_view(cost.effect) == effect) return cost.seconds;
    return effect_costs_.emplace_back(EffectCost{effect, 0.0}).seconds;
}

/// Gravity, less the acceleration of the frame.
Vec2 Simulation::body_acceleration() const {
    const Vec2 gravity{0.0, -run_.gravity};
    return ground_motion_ ? Vec2(gravity - ground_motion_->acceleration(time_)) : gravity;
}

double Simulation::rate_of_rise() const {
    double sum = 0.0;
    for (int i = 0; i < soil_.count; ++i) sum += soil_.vy[i];
    return sum;
}

/// What takes from the velocity after the projection. Gravity has done its work at the velocity before, and
/// the soil moves with the one after.
void Simulation::damp(double dt) {
    const double before = rate_of_rise();
    if (filter_) friction_work_ += discretisation_.mass() * filter_->apply(neighbours_, wall_, bed_, soil_);
    if (effects_.side_walls) brake(dt);
    numerical_work_ += dt * discretisation_.mass() * run_.gravity * (before - rate_of_rise());
}

void Simulation::brake(double dt) {
    const Stopwatch watch(cost_of("side_walls"));
    side_wall_work_ +=
        discretisation_.mass() * brake_by_side_walls(*effects_.side_walls, discretisation_,
                                                     pore_water_ ? &pore_pressure_ : nullptr, dt, soil_);
}

/// Particles under tension draw together in clumps (the tensile instability of SPH), and the soil tears where
/// it should hold. They are moved a little from where it is crowded to where it is not, in the inside of the
/// body only (particle shifting, Lind et al. 2012), and only on their way, so that soil at rest stays where
/// it is.
void Simulation::even_out(double dt) {
    const double scale = shifting * discretisation_.volume();
    const double most = most_shifting * discretisation_.spacing;
    for (int i = 0; i < soil_.count; ++i) {
        if (neighbours_.density[i] < surface_density || neighbours_.rests(i)) continue;
        Vec2 step{-scale * neighbours_.surface_x[i], -scale * neighbours_.surface_y[i]};
        const double size = step.norm();
        const double longest = std::min(most, shifting_way * dt * std::hypot(soil_.vx[i], soil_.vy[i]));
        if (size > longest) step *= longest / size;
        soil_.x[i] += step.x();
        soil_.y[i] += step.y();
        numerical_work_ -= discretisation_.mass() * run_.gravity * step.y();
    }
}

void Simulation::measure_barrier(double dt) {
    const Stopwatch watch(cost_of("barrier"));
    barrier_->measure(neighbours_, soil_, wall_, dt);
}

/// Soil of the layer counts as debris from when it has moved by two spacings, and stays it.
void Simulation::note_moved_layer() {
    const double far2 = std::pow(moved_spacings * discretisation_.spacing, 2);
    resting_layer_.assign(static_cast<std::size_t>(soil_.count), 0);
    for (int i = 0; i < soil_.count; ++i) {
        if (soil_.id[i] < first_layer_id_ || soil_.id[i] >= end_layer_id_) continue;
        char& moved = layer_moved_[static_cast<std::size_t>(soil_.id[i] - first_layer_id_)];
        if (moved == 0 && (Vec2{soil_.x[i], soil_.y[i]} - start_[soil_.id[i]]).squaredNorm() > far2)
            moved = 1;
        resting_layer_[i] = moved == 0 ? 1 : 0;
    }
}

double Simulation::eroded_area() const {
    return discretisation_.volume() *
           static_cast<double>(std::count(layer_moved_.begin(), layer_moved_.end(), 1));
}

std::vector<double> Simulation::strain_rate() const {
    std::vector<FloatPair> velocity;
    soil_velocities(neighbours_, soil_, velocity);
    std::vector<double> rate(soil_.count, 0.0);
    for (const PairBlock& block : neighbours_.blocks) {
        for_each_velocity_gradient(block, neighbours_, velocity.data(),
                                   [&](int i, const VelocityGradient& plain) {
                                       const VelocityGradient g = plain.corrected(neighbours_, i);
                                       rate[i] = std::hypot(g.exx(), g.exy());
                                   });
    }
    return rate;
}

/// More soil, at rest. What was at rest is taken as at rest, and energy is reckoned anew from here.
void Simulation::add_soil(const std::vector<Vec2>& points) {
    append_soil(soil_, points);
    start_.insert(start_.end(), points.begin(), points.end());
    if (pore_water_) pore_water_->append(points);
    make_room();
    rest_.start(soil_, time_);
    if (sleep_) sleep_->append(soil_);
    invariants_.restart(height_);
    stage_start_ = time_;
    stage_ended_ = false;
}

/// One more layer of a poured heap: a lattice at the uphill end, its lowest row one spacing above the highest
/// particle beneath it (Fig. 5 of the paper). Its stress is that of free fall, none. What was at rest is
/// taken as at rest, and energy is reckoned anew from here.
void Simulation::release_layer() {
    const double dl = discretisation_.spacing;
    const int columns = std::max(1, static_cast<int>(std::lround(release_.layer_width / dl)));
    const int rows = std::max(1, static_cast<int>(std::lround(release_.layer_height / dl)));
    // Not at the head itself, where a wall may stand.
    double top = bed_.elevation(release_head_ + 0.5 * dl);
    for (int i = 0; i < soil_.count; ++i) {
        if (soil_.x[i] < release_head_ + columns * dl) top = std::max(top, soil_.y[i]);
    }
    std::vector<Vec2> layer;
    for (int i = 0; i < columns; ++i) {
        for (int j = 0; j < rows; ++j)
            layer.emplace_back(release_head_ + (i + 0.5) * dl, top + (j + 1.0) * dl);
    }
    height_ = std::max(height_, top + (rows + 0.5) * dl - floor_);
    add_soil(layer);
    ++layers_released_;
}

/// The next mass of a staged release, with the bed that it leaves.
void Simulation::release_mass() {
    const LaterMass& mass = release_.masses[masses_released_++];
    ground_ = BedLine(mass.bed);
    bed_ = BedLine(shape_bed(mass.bed, effects_));
    wall_ = make_wall(bed_, discretisation_);
    pressure_.forget_wall();
    friction_.set_yield(YieldStrength(material_, effects_, base_strength_ratios(material_, effects_, wall_)));
    if (barrier_) barrier_->find_segments(bed_, wall_);
    const std::vector<Vec2> points = place_mass(mass, soil_, discretisation_.spacing, run_.smoothing_ratio);
    for (const Vec2& p : points) height_ = std::max(height_, p.y() - floor_);
    add_soil(points);
    if (sleep_) sleep_->wake_all(soil_, time_);
}

}  // namespace runout
