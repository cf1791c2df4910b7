#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace runout {

/// One effect of a case with its cost, measured on the case.
struct MeasuredEffect {
    std::string name;
    bool on = false;
    std::string why;
    double share =
        0;  ///< CPU time of a step with it over that without it, less 1; NaN: off, or cannot be taken away
};

/// Runs the first steps of the scene at a low resolution with all its effects and without each of them, and
/// compares the CPU time of a particle step, best of three. Noise of a busy machine is some per cent.
std::vector<MeasuredEffect> measure_effects(const Scene& scene);

}  // namespace runout
