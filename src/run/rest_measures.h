#pragma once

#include <vector>

#include "engine/simulation.h"
#include "measures/deposit.h"
#include "measures/measures.h"
#include "measures/reach.h"
#include "scene/scene.h"

namespace runout {

/// The state that a run ended in, with what was seen of its way.
struct EndState {
    const Simulation& simulation;
    const ReachRecorder& reach;  ///< has looked at the end
    const DepositProfile& profile;
    const std::vector<char>& body;  ///< as connected_body
    double peak_mass_point_speed = 0;
};

/// What is said of the run.
Measures measures_at_rest(const Scene& scene, const EndState& end);

/// The heap when a stage of a staged release has come to rest.
StageRow stage_at_rest(const Scene& scene, const Simulation& simulation);

/// How a run ended and why, where its numbers are none.
struct Verdict {
    RunStatus status = RunStatus::running;
    std::string detail;
};

/// Whether what came to rest may be told as a run-out: not where most of it is spray, nothing is as thick as
/// the front, or the front left the section. Else as the simulation ended.
Verdict verdict_on(const Simulation& simulation, const ReachRecorder& reach, const Measures& measures);

/// A sentence where more of the soil than usual lies apart from the body; else empty.
std::string spray_warning(const Simulation& simulation, const Measures& measures);

}  // namespace runout
