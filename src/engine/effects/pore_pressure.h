#pragma once

#include <vector>

#include "engine/effects/effects.h"
#include "engine/pairs/particle_system.h"
#include "engine/particles/kernel.h"

namespace runout {

/// Soil thickness over chainage, by mass: each particle's volume is shared between the two nearest columns,
/// so that the sum is exact and linear surfaces stay linear.
class ColumnThickness {
  public:
    void measure(const Neighbours& n, const Soil& soil, const Discretisation& discretisation);
    /// m, linear between the columns.
    [[nodiscard]] double at(double x) const;

  private:
    double first_ = 0, width_ = 1;
    std::vector<double> thickness_;
};

/// Water in the pores: u = r rho g d, d the vertical depth below the soil's surface as it is now. r is
/// carried by the soil from where it started; next to the bed (within the kernel's reach) an excess adds to
/// it, which decays with exp(-t/T).
class PoreWater {
  public:
    /// `starts`: positions at release by the soil's id, m.
    PoreWater(const PorePressure& effect, const Discretisation& discretisation, double gravity,
              const std::vector<Vec2>& starts);

    /// For soil that is let go later, ids following.
    void append(const std::vector<Vec2>& starts);

    /// u of every node where the particles are now, Pa; valid until the next call.
    const std::vector<double>& find(const ParticleSystem& particles, double time);
    /// As found last.
    [[nodiscard]] const std::vector<double>& pressure() const { return pressure_; }

  private:
    PorePressure effect_;
    Discretisation discretisation_;
    double gravity_;
    std::vector<double> ratio_;  ///< r_u by id
    ColumnThickness thickness_;
    std::vector<double> pressure_;  ///< per node, Pa
};

}  // namespace runout
