#pragma once

#include <vector>

#include "engine/pairs/neighbours.h"
#include "engine/particles/bed_line.h"
#include "engine/particles/kernel.h"
#include "engine/particles/soil.h"
#include "engine/particles/wall.h"
#include "scene/effects.h"

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

    /// On return `pressure` has u of every node, Pa.
    void find(const Neighbours& n, const Soil& soil, const Wall& wall, const BedLine& bed, double time,
              std::vector<double>& pressure);

  private:
    PorePressure effect_;
    Discretisation discretisation_;
    double gravity_;
    std::vector<double> ratio_;  ///< r_u by id
    ColumnThickness thickness_;
};

}  // namespace runout
