#pragma once

#include <vector>

#include "engine/effects/effect_set.h"
#include "engine/pairs/particle_system.h"
#include "engine/watch/invariants.h"
#include "engine/watch/work_ledger.h"

namespace runout {

/// Puts back soil that comes too near the bed line; see src/engine/README.md. Pressure keeps most soil out.
/// Carried here are soil that has just landed, and lone grains, which no pressure holds.
class BedGuard {
  public:
    BedGuard(const Discretisation& discretisation, double gravity)
        : discretisation_(discretisation), gravity_(gravity) {}

    /// Puts back each particle that is nearer to the bed line than it may come, in company by at most half a
    /// spacing, and takes its velocity into the bed. `node_pressure`: of this step, Pa. Returns how many
    /// particles were driven in, and how deep the deepest still is.
    StepFacts put_back(ParticleSystem& particles, const std::vector<double>& node_pressure, double dt,
                       EffectSet& effects, WorkLedger& ledger);

  private:
    /// What it works on in one step.
    struct Step {
        ParticleSystem& particles;
        const std::vector<double>& node_pressure;
        double dt;
        EffectSet& effects;
        WorkLedger& ledger;
    };

    [[nodiscard]] double clearance(const Neighbours& n, int i) const;
    void find_gaps(ParticleSystem& particles);
    void put_back(int i, const Step& step, StepFacts& facts);
    Vec2 push_back(int i, double distance, const Vec2& normal, const Step& step);

    Discretisation discretisation_;
    double gravity_;
    std::vector<double> gap_;  ///< distance to the bed line, less that to which it may come, per particle, m
    std::vector<char> some_inside_;  ///< per chunk: some of it is nearer
};

}  // namespace runout
