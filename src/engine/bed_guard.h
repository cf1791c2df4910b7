#pragma once

#include <vector>

#include "engine/effects/effect_set.h"
#include "engine/pairs/particle_system.h"
#include "engine/watch/invariants.h"
#include "engine/watch/work_ledger.h"

namespace runout {

/// Puts back soil that comes too near the bed line; see docs/engine.md. Pressure keeps most of it out; what
/// lands, and grains alone, which no pressure holds, are carried here.
class BedGuard {
  public:
    BedGuard(const Discretisation& discretisation, double gravity)
        : discretisation_(discretisation), gravity_(gravity) {}

    /// No particle nearer the bed line than it may come: it is put back, in company by at most half a
    /// spacing, and its velocity into the bed ends. `node_pressure`: of this step, Pa. Says how many were
    /// driven in and how deep the deepest still is.
    StepFacts put_back(ParticleSystem& particles, const std::vector<double>& node_pressure, double dt,
                       EffectSet& effects, WorkLedger& ledger);

  private:
    /// What a step gives, and what it takes.
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
    std::vector<double> gap_;        ///< to how near the bed line a particle may come, per particle, m
    std::vector<char> some_inside_;  ///< per chunk: some of it is nearer
};

}  // namespace runout
