#pragma once

#include <vector>

#include "engine/effects.h"
#include "engine/pairs/particle_system.h"
#include "engine/particles/discretisation.h"

namespace runout {

/// Thickness of the soil along x, by mass. Each particle's volume is divided between the two nearest columns,
/// so that the total is exact and a surface that is linear stays linear.
class ColumnThickness {
  public:
    void measure(const Neighbours& n, const Soil& soil, const Discretisation& discretisation);
    /// Thickness at x, m; linear between the columns.
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

    /// Soil was added: its positions, m, with numbers that follow those before.
    void append(const std::vector<Vec2>& starts);

    /// u of every node where the particles are now, Pa; valid until the next call.
    const std::vector<double>& find(const ParticleSystem& particles, double time);
    /// u as found last, per node, Pa.
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
