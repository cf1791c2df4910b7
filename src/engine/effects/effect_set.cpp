#include "engine/effects/effect_set.h"

#include "engine/effects/cohesion.h"
#include "engine/effects/side_walls.h"
#include "engine/pairs/packing.h"
#include "engine/particles/chain.h"
#include "engine/watch/phase_clock.h"

namespace runout {
namespace {

// How much the velocity filter takes out in a step, of cohesive soil and where friction depends on the rate.
// With the lesser value a cut near its limit slowly comes apart; with the greater one Bagnold's profile is
// off by 3.0 % in place of 2.7.
constexpr double standing_filter = 0.5;
constexpr double flowing_filter = 0.25;

double sum_of_rise(const Soil& soil) {
    double sum = 0.0;
    for (int i = 0; i < soil.count; ++i) sum += soil.vy[i];
    return sum;
}

}  // namespace

EffectSet::EffectSet(const Problem& problem, const Discretisation& discretisation)
    : material_(problem.material),
      effects_(problem.effects),
      discretisation_(discretisation),
      gravity_(problem.settings.gravity),
      smoothing_ratio_(problem.settings.smoothing_ratio) {
    if (effects_.erodible_bed)
        effects_.erodible_bed = with_whole_particles(*effects_.erodible_bed, discretisation.spacing);
    if (cohesive() || (effects_.rate && effects_.rate->increase != 0.0))
        filter_.emplace(discretisation_, cohesive() ? standing_filter : flowing_filter);
    if (effects_.shaking) shaking_.emplace(*effects_.shaking);
}

Polyline EffectSet::bed_under(const Polyline& ground) const {
    Polyline bed = ground;
    if (effects_.erodible_bed) bed = lowered_by(bed, *effects_.erodible_bed);
    if (effects_.barrier) bed = replaced(bed, barrier_outline(bed, *effects_.barrier));
    return bed;
}

std::vector<Vec2> EffectSet::layer_soil(const Polyline& ground, int first_id) {
    if (!effects_.erodible_bed) return {};
    const Polygon outline = layer_outline(ground, *effects_.erodible_bed);
    const Mass layer{outline, bed_under(ground), polygon_area(outline)};
    std::vector<Vec2> points = pack_mass(layer, discretisation_.spacing, smoothing_ratio_).points;
    layer_.emplace(first_id, first_id + static_cast<int>(points.size()), discretisation_.spacing);
    return points;
}

void EffectSet::start(const Polyline& ground, const ParticleSystem& particles,
                      const std::vector<Vec2>& starts) {
    if (layer_) layer_->observe(particles.soil, starts);
    if (effects_.pore_pressure) water_.emplace(*effects_.pore_pressure, discretisation_, gravity_, starts);
    if (!effects_.barrier) return;
    const Polyline bare = effects_.erodible_bed ? lowered_by(ground, *effects_.erodible_bed) : ground;
    barrier_.emplace(barrier_outline(bare, *effects_.barrier), particles.wall, discretisation_);
}

void EffectSet::take_in(const std::vector<Vec2>& starts) {
    if (water_) water_->append(starts);
}

void EffectSet::take_new_wall(const Wall& wall) {
    if (barrier_) barrier_->find_segments(wall);
}

YieldStrength EffectSet::yield_strength(const Wall& wall) const {
    return {material_, effects_, base_strength_ratios(material_, effects_, wall)};
}

Wall EffectSet::wall_under(const Polyline& ground) const {
    Wall wall = make_wall(BedLine(bed_under(ground)), discretisation_);
    wall.slips = slipping_base(material_, effects_, wall);
    return wall;
}

Vec2 EffectSet::body_acceleration(double time) const {
    const Vec2 gravity{0.0, -gravity_};
    return shaking_ ? gravity - shaking_->acceleration(time) : gravity;
}

const std::vector<double>* EffectSet::pore_pressure(const ParticleSystem& particles, double time) {
    if (!water_) return nullptr;
    const Stopwatch watch(cost_of(EffectId::pore_pressure));
    return &water_->find(particles, time);
}

/// The work of gravity was reckoned with the velocity before, but the soil moves with the one after. The
/// difference is booked as numerical.
void EffectSet::damp(ParticleSystem& particles, double dt, WorkLedger& ledger) {
    if (!filter_ && !effects_.side_walls) return;
    const double before = sum_of_rise(particles.soil);
    if (filter_) ledger.friction += discretisation_.mass() * filter_->apply(particles);
    if (effects_.side_walls) brake(particles, dt, ledger);
    ledger.numerical += dt * discretisation_.mass() * gravity_ * (before - sum_of_rise(particles.soil));
}

void EffectSet::brake(ParticleSystem& particles, double dt, WorkLedger& ledger) {
    const Stopwatch watch(cost_of(EffectId::side_walls));
    ledger.side_walls += discretisation_.mass() * brake_by_side_walls(*effects_.side_walls, discretisation_,
                                                                      water_ ? &water_->pressure() : nullptr,
                                                                      dt, particles.soil);
}

void EffectSet::shift(ParticleSystem& particles, double dt, WorkLedger& ledger) {
    if (cohesive()) shift_crowded(particles, discretisation_, gravity_, dt, ledger);
}

void EffectSet::add_guard_impulse(int segment, const Vec2& impulse) {
    if (barrier_) barrier_->add_guard_impulse(segment, impulse);
}

void EffectSet::observe(const ParticleSystem& particles, const std::vector<Vec2>& starts, double dt) {
    if (barrier_) {
        const Stopwatch watch(cost_of(EffectId::barrier));
        barrier_->measure(particles, dt);
    }
    if (layer_) layer_->observe(particles.soil, starts);
}

std::span<const char> EffectSet::unmoved_layer() const {
    return layer_ ? std::span(layer_->unmoved()) : std::span<const char>{};
}

double EffectSet::eroded_area() const {
    return layer_ ? discretisation_.volume() * static_cast<double>(layer_->moved()) : 0.0;
}

double& EffectSet::cost_of(EffectId effect) {
    for (EffectCost& cost : costs_)
        if (cost.effect == effect) return cost.seconds;
    return costs_.emplace_back(EffectCost{effect, 0.0}).seconds;
}

}  // namespace runout
