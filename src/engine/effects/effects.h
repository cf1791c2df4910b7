#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "core/geometry.h"
#include "engine/particles/mass.h"

namespace runout {

// What goes beyond gravity, Coulomb friction, incompressibility and a rough rigid bed. Each effect is absent
// unless a case names it, and then it is nothing: no state, no work. Formulas, sources and ranges of
// validity: docs/effects.md. SI and radians; positions are x of the frame of the problem.

/// Part of the bed with a friction of its own.
struct FrictionRange {
    double from = 0, to = 0;  ///< x, m
    double angle = 0;         ///< delta, rad
};

/// Coulomb friction between the soil and its bed where it is less than the soil's own.
struct BaseFriction {
    /// delta outside the ranges, rad: traction on the bed at most p tan(delta); NaN: rough.
    double angle = std::numeric_limits<double>::quiet_NaN();
    std::vector<FrictionRange> ranges{};  ///< do not overlap
};

/// Strength that does not come from pressure: |s| <= c cos(phi) + p sin(phi).
struct Cohesion {
    double strength = 0;  ///< c, Pa
    /// Greatest mean tension that the soil bears, Pa; NaN: that of uniaxial tension at yield.
    double tension = std::numeric_limits<double>::quiet_NaN();
};

/// Friction that grows with the inertial number, mu(I) of Jop et al. 2006: sin(phi) + increase/(1 + I0/I).
struct RateDependence {
    double increase = 0.26;          ///< mu_2 - mu_s
    double inertial_number = 0.279;  ///< I0
    double grain_diameter = 0;       ///< d, m
    double grain_density = 2650;     ///< kg/m3
};

/// Water in the pores: u = ratio x rho g x vertical depth is taken off the pressure in the yield rule.
struct PorePressure {
    double ratio = 0;           ///< r_u of the whole mass
    std::vector<Vec2> field{};  ///< (x, r_u), x rising: r_u by where the soil starts, in place of `ratio`
    double base_excess = 0;     ///< more of it within the kernel's reach of the bed, at release
    /// Time in which the excess falls to 1/e, s.
    double dissipation_time = std::numeric_limits<double>::infinity();
};

/// Rigid obstacle on the bed.
struct Barrier {
    double x = 0;                             ///< foot of the face that the debris meets, m
    double height = 0;                        ///< m
    double inclination = 1.5707963267948966;  ///< of that face against the horizontal, rad
    double thickness = 0;                     ///< at the top, m; 0: half the height
    double load_coefficient = 2.5;            ///< alpha of the design load alpha rho v^2
};

/// Acceleration of the ground, m/s2, in whose frame the run is computed. x towards the run-out.
struct Shaking {
    std::vector<double> time{};  ///< s, rising; empty: constant
    std::vector<double> horizontal{}, vertical{};
};

/// Friction of the walls of a channel.
struct SideWalls {
    double width = 0;  ///< m
    double angle = 0;  ///< of the wall friction, rad
};

/// A mass that is let go later than the first. Its bed is the ground left when it has gone too.
struct LaterMass {
    double time = 0;  ///< s
    Mass mass{};
};

/// Several releases, one after the other.
struct StagedRelease {
    // Pouring: each time the soil has come to rest, one more layer is let go just above its uphill end.
    int layers = 0;
    double layer_width = 0;           ///< m
    double layer_height = 0;          ///< m
    std::vector<LaterMass> masses{};  ///< by time
};

/// Soil of the same material that lies at rest in the bed until it yields.
struct ErodibleBed {
    double depth = 0;         ///< m, vertical
    double from = 0, to = 0;  ///< x, m
};

/// What goes beyond the core: absent unless the case names it.
struct Effects {
    std::optional<BaseFriction> base_friction{};
    std::optional<Cohesion> cohesion{};
    std::optional<RateDependence> rate{};
    std::optional<PorePressure> pore_pressure{};
    std::optional<Barrier> barrier{};
    std::optional<Shaking> shaking{};
    std::optional<SideWalls> side_walls{};
    std::optional<StagedRelease> release{};
    std::optional<ErodibleBed> erodible_bed{};
};

/// The same effects as names.
enum class EffectId {
    base_friction,
    cohesion,
    rate,
    pore_pressure,
    barrier,
    shaking,
    side_walls,
    release,
    erodible_bed,
};

/// Seconds that an effect's own work took.
struct EffectCost {
    EffectId effect;
    double seconds = 0;
};

}  // namespace runout
