#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/effects.h"
#include "engine/effects/barrier.h"
#include "engine/effects/erodible_bed.h"
#include "engine/effects/pore_pressure.h"
#include "engine/effects/shaking.h"
#include "engine/friction/velocity_filter.h"
#include "engine/friction/yield_strength.h"
#include "engine/pairs/particle_system.h"
#include "engine/problem.h"
#include "engine/watch/work_ledger.h"

namespace runout {

/// The effects that a problem names, at work. A step calls the verbs below in their order. An effect that is
/// absent has no state and does nothing.
class EffectSet {
  public:
    EffectSet(const Problem& problem, const Discretisation& discretisation);

    // Before the start, and when soil or bed has changed.

    /// The rigid bed under this ground: lowered by the erodible layer, with the barrier on it. The ground
    /// itself where there is neither.
    [[nodiscard]] Polyline bed_under(const Polyline& ground) const;
    /// Particles of the erodible layer, m; none without one. `first_id`: the number of its first particle.
    std::vector<Vec2> layer_soil(const Polyline& ground, int first_id);
    /// To be called once, when soil and bed are there. `starts`: positions of all soil at release by id, m.
    void start(const Polyline& ground, const ParticleSystem& particles, const std::vector<Vec2>& starts);
    /// Soil was added: its positions by id, m, with numbers that follow those before.
    void take_in(const std::vector<Vec2>& starts);
    /// The bed has changed.
    void take_new_wall(const Wall& wall);

    // Strength.

    [[nodiscard]] YieldStrength yield_strength(const Wall& wall) const;
    /// Wall particles along the bed that the effects make of `ground`.
    [[nodiscard]] Wall wall_under(const Polyline& ground) const;
    /// Strength on the bed at x over the effective pressure.
    [[nodiscard]] double base_strength(double x) const { return base_strength_ratio(material_, effects_, x); }
    /// Greatest mean tension that the soil bears, Pa; 0 without cohesion.
    [[nodiscard]] double tension() const { return tension_cut_off(material_, effects_); }
    [[nodiscard]] bool cohesive() const { return effects_.cohesion && effects_.cohesion->strength > 0.0; }

    // In a step, in this order.

    /// Gravity, less the acceleration of the frame, m/s2.
    [[nodiscard]] Vec2 body_acceleration(double time) const;
    /// u per node, Pa; null: dry.
    const std::vector<double>* pore_pressure(const ParticleSystem& particles, double time);
    /// After the projection: takes from the velocity.
    void damp(ParticleSystem& particles, double dt, WorkLedger& ledger);
    /// After the motion: moves particles a little.
    void shift(ParticleSystem& particles, double dt, WorkLedger& ledger);
    /// The bed took this impulse of a particle (kg m/s) from the soil at one of its segments.
    void add_guard_impulse(int segment, const Vec2& impulse);
    /// At the end of the step: reads off what the soil does to a barrier and to an erodible layer.
    void observe(const ParticleSystem& particles, const std::vector<Vec2>& starts, double dt);

    // What is known of them.

    /// At `time` something still acts that could set soil at rest in motion.
    [[nodiscard]] bool act_at(double time) const { return shaking_ && time < shaking_->ends(); }
    /// Null without a barrier.
    [[nodiscard]] const BarrierForce* barrier_force() const { return barrier_ ? &barrier_->now() : nullptr; }
    /// Per soil particle, 1 where it is of the erodible layer and has not moved; empty without such a layer.
    [[nodiscard]] std::span<const char> unmoved_layer() const;
    /// Soil of the layer that has moved, m2.
    [[nodiscard]] double eroded_area() const;
    [[nodiscard]] const std::vector<EffectCost>& costs() const { return costs_; }

  private:
    double& cost_of(EffectId effect);
    void brake(ParticleSystem& particles, double dt, WorkLedger& ledger);

    Material material_;
    Effects effects_;
    Discretisation discretisation_;
    double gravity_;
    double smoothing_ratio_;
    std::optional<VelocityFilter> filter_;  ///< of cohesive soil, and where friction depends on the rate
    std::optional<PoreWater> water_;
    std::optional<GroundMotion> shaking_;
    std::optional<BarrierLoad> barrier_;
    std::optional<UnmovedLayer> layer_;
    std::vector<EffectCost> costs_;
};

}  // namespace runout
