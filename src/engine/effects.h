#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "core/geometry.h"
#include "engine/mass.h"

namespace runout {

// What goes beyond gravity, Coulomb friction, incompressibility and a rough rigid bed. An effect that a
// problem does not name is absent: it has no state and does no work. Formulas, sources and ranges of
// validity: docs/effects.md. SI and radians; positions are x of the frame of the problem.

/// Part of the bed with a friction of its own.
struct FrictionRange {
    double from = 0,   ///< x where it begins, m
        to = 0;        ///< x where it ends, m; from < to
    double angle = 0;  ///< delta, rad
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
    double inertial_number = 0.279;  ///< I0, at which half of the increase is there
    double grain_diameter = 0;       ///< d, m
    double grain_density = 2650;     ///< kg/m3
};

/// Water in the pores: u = ratio x rho g x vertical depth is taken off the pressure in the yield rule.
struct PorePressure {
    double ratio = 0;  ///< r_u of the whole mass
    /// r_u by where the soil starts, in place of `ratio`: (x in m, r_u), x rising.
    std::vector<Vec2> field{};
    double base_excess = 0;  ///< what r_u is greater by at release, within the kernel's reach of the bed
    /// Time in which the excess falls to 1/e, s.
    double dissipation_time = std::numeric_limits<double>::infinity();
};

/// Rigid obstacle on the bed.
struct Barrier {
    double x = 0;                             ///< foot of the face that the debris meets, m
    double height = 0;                        ///< of the top over that foot, m
    double inclination = 1.5707963267948966;  ///< of that face against the horizontal, rad
    double thickness = 0;                     ///< at the top, m
    double load_coefficient = 2.5;            ///< alpha of the design load alpha rho v^2
};

/// Acceleration of the ground, in whose frame the run is computed. Linear between the instants of a record;
/// still after its end.
struct Shaking {
    std::vector<double> time{};        ///< s since release, rising; empty: constant acceleration
    std::vector<double> horizontal{},  ///< m/s2, x towards the run-out; one per instant, or one in all
        vertical{};                    ///< m/s2, upwards; likewise
};

/// Friction of the walls of a channel.
struct SideWalls {
    double width = 0;  ///< between the two walls, m
    double angle = 0;  ///< of the wall friction, rad
};

/// A mass that is let go later than the first. Its bed is the ground left when it has gone too.
struct LaterMass {
    double time = 0;  ///< at which it is let go, s
    Mass mass{};      ///< and what is let go
};

/// Several releases, one after the other.
struct StagedRelease {
    /// Pouring: each time the soil has come to rest, one more layer is let go just above its uphill end, so
    /// many in all.
    int layers = 0;
    double layer_width = 0;           ///< m
    double layer_height = 0;          ///< m
    std::vector<LaterMass> masses{};  ///< by rising time
};

/// Soil of the same material that lies at rest in the bed until it yields.
struct ErodibleBed {
    double depth = 0;  ///< m, vertical; rounded to whole particles, at least one
    double from = 0,   ///< x where it begins, m
        to = 0;        ///< x where it ends, m; from < to
};

/// What goes beyond the core: absent unless it is set.
struct Effects {
    std::optional<BaseFriction> base_friction{};  ///< else the bed is rough
    std::optional<Cohesion> cohesion{};           ///< else the soil has friction only
    std::optional<RateDependence> rate{};         ///< else friction does not depend on the rate
    std::optional<PorePressure> pore_pressure{};  ///< else the soil is dry
    std::optional<Barrier> barrier{};             ///< else nothing stands in the way
    std::optional<Shaking> shaking{};             ///< else the ground is still
    std::optional<SideWalls> side_walls{};        ///< else the slide is infinitely wide
    std::optional<StagedRelease> release{};       ///< else the whole mass is let go at once
    std::optional<ErodibleBed> erodible_bed{};    ///< else the bed is rigid
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

/// What an effect's own work took so far.
struct EffectCost {
    EffectId effect;     ///< whose
    double seconds = 0;  ///< at the clock, s
};

}  // namespace runout
