#pragma once

#include <vector>

#include "core/geometry.h"
#include "engine/friction/friction.h"
#include "engine/pairs/particle_system.h"
#include "engine/particles/bed_line.h"
#include "engine/pressure/pressure_solver.h"

namespace runout::numerics {

inline constexpr double density = 1000.0;  ///< rho_0, kg/m3; no result depends on it

/// Centres of the cells of a square lattice over [x0, x1] x [y0, y1].
std::vector<Vec2> lattice(double spacing, const Vec2& lower, const Vec2& upper);
/// Moves every point at random, evenly by up to `share` of a spacing each way; the same on every machine.
void jitter(std::vector<Vec2>& points, double spacing, double share, unsigned seed);

/// Particles, bed and who is near whom, by the engine's own parts.
struct Cloud : ParticleSystem {
    Cloud(double spacing, const std::vector<Vec2>& points, const BedLine& bed_line);

    /// Sorts the particles and finds their neighbours where they stand now.
    void find();
    /// Pressure gradient of eq. 4 of a pressure per node, Pa/m.
    [[nodiscard]] NodeVectors pressure_gradient(const std::vector<double>& pressure) const;

    Discretisation d;
    NeighbourSearch search;
};

/// First moment of the kernel's gradient over the full lattice, 1 in the limit of many neighbours: what the
/// plain gradient multiplies a slope by.
double lattice_moment(const Discretisation& d);

/// A bed line so far away that nobody sees it.
BedLine no_bed();

/// A soil without strength that marches as `Simulation` does, without its judgement of runs: neighbours ->
/// time step -> friction -> pressure -> correct -> move -> guard of the wall.
class Fluid {
  public:
    /// `speed`, `length`: scales of the motion, which only set the time in which excess density is worked
    /// off. `gravity`: m/s2, downwards.
    Fluid(double spacing, const std::vector<Vec2>& points, const BedLine& bed, double speed, double length,
          double gravity);

    /// One step, at most until `end`, s.
    void step(double end);
    [[nodiscard]] double time() const { return time_; }
    /// sum of v^2 / 2 times dl^2: kinetic energy over rho_0, m4/s2.
    [[nodiscard]] double kinetic_energy() const;
    Cloud cloud;

  private:
    [[nodiscard]] double time_step() const;
    void guard_wall();

    double gravity_;
    Friction friction_;
    PressureSolver pressure_;
    NodeVectors predicted_, gradient_;
    double highest_pressure_ = 0;
    double time_ = 0;
};

}  // namespace runout::numerics
