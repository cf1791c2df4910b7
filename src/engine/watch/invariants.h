#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/particles/soil.h"
#include "engine/watch/invariant_readings.h"

namespace runout {

/// Of what the units of the readings are made.
struct InvariantScales {
    double gravity = 0;  ///< m/s2
    double height = 0;   ///< H, m
    double spacing = 0;  ///< dl, m
    double density = 0;  ///< rho_0, kg/m3
    double courant = 0;  ///< of the step, eq. 6
    double tension = 0;  ///< mean tension that the soil bears, Pa
};

/// What a step did, beyond the state it left.
struct StepFacts {
    double time = 0;            ///< s, after the step
    double dt = 0;              ///< s
    int unconverged = 0;        ///< steps in a row up to this one that missed the tolerance
    double work_done = 0;       ///< taken from the motion since release, J/kg, mean of the particles
    double work_supplied = 0;   ///< given to it by shaking since release, likewise
    long driven_in = 0;         ///< particles that the bed guard had to put back
    double greatest_depth = 0;  ///< behind the bed line after the guard, m
    double depth_x = 0;         ///< where
};

/// Sums and extremes over some of the soil after a step. Those of several parts are added up.
struct SoilSurvey {
    long count = 0;
    double energy = 0;                 ///< kinetic and potential, sum over the particles, J/kg
    double excess = 0;                 ///< sum of the density above rho_0, in rho_0
    long long numbers = 0;             ///< sum of the particles' numbers
    double speed2 = 0, fastest_x = 0;  ///< of the fastest, m2/s2; NaN stays
    double density = 0, densest_x = 0;
    double tension = 0, tension_x = 0;  ///< the greatest, Pa; NaN stays
    double first_x = std::numeric_limits<double>::infinity();
    double last_x = -std::numeric_limits<double>::infinity();

    SoilSurvey& operator+=(const SoilSurvey& next);
};

/// That of the soil [first, last). `density`: rho / rho_0 per particle.
SoilSurvey survey(const Soil& soil, const std::vector<double>& density, double gravity, int first, int last);

/// Checks the invariants after every step.
class InvariantWatch {
  public:
    explicit InvariantWatch(const InvariantScales& scales);

    /// Soil was added at rest. `height`: H of the units from now on, m. Energy is reckoned anew from here.
    void restart(double height);
    /// To be called after each step. `soil`: of all soil.
    void observe(const SoilSurvey& soil, const StepFacts& step);

    /// "energy_rise at t = 0.31 s, x = 1.2 m: 0.034, at most 0.02" for the first one violated, if any.
    [[nodiscard]] const std::optional<std::string>& violation() const { return violation_; }
    [[nodiscard]] const InvariantReadings& readings() const { return readings_; }
    /// What the next time steps are to be multiplied by. 1 as long as the readings of bed_guard and volume
    /// are below half of their limits, then less, and a quarter at the limit: long steps drive soil into the
    /// bed and press it together.
    [[nodiscard]] double pace() const;

  private:
    void note(Invariant invariant, double value, double x);
    void note_energy(double mechanical, double fastest_x, const StepFacts& step);

    InvariantScales scales_;
    InvariantReadings readings_;
    double time_ = 0;
    std::optional<std::string> violation_;
    double start_energy_ = 0;  ///< less what shaking supplied, J/kg, mean of the particles
    double least_energy_ = 0;
    double start_work_ = 0;
    bool started_ = false;
    double least_crowding_ = 0;  ///< mean excess of density, the least so far
    double driven_in_ = 0;       ///< sum over steps of the fraction of particles
    long steps_ = 0;
};

}  // namespace runout
