#pragma once

#include <span>
#include <vector>

#include "store/store.h"

namespace runout {

/// What a run took. Counts are of the whole run.
struct CostSample {
    double resolution = 0;  ///< sqrt(S) / particle spacing
    double particles = 0;
    double steps = 0;
    double pressure_iterations = 0;
    double cpu_s = 0;
    double peak_memory_mb = 0;  ///< 0: not known
};

CostSample cost_sample(double resolution, const RunWork& work);

/// CPU seconds of a run on one machine: steps (a + particles (b + c iterations per step)).
struct CostModel {
    double per_step_s = 0;
    double per_particle_step_s = 0;
    double per_particle_iteration_s = 0;

    [[nodiscard]] double cpu_seconds(const CostSample& counts) const;
};

/// Least squares of the relative error, no coefficient below zero. Throws std::invalid_argument without a
/// sample that took time.
CostModel fit_cost_model(std::span<const CostSample> samples);

/// The counts that a run of the same scene with `resolution` will have, from those of coarser (or finer)
/// ones: particles grow with the square of the resolution; steps with a power of it, which is fitted where
/// the samples differ by half an octave or more and is 1 otherwise; iterations a step stay; memory grows with
/// the particles. `cpu_s` is left zero. Throws std::invalid_argument without samples.
CostSample expected_counts(std::span<const CostSample> samples, double resolution);

/// expected_counts with the seconds of `model`, times the factor by which `samples` themselves were off it (a
/// machine that is slower, or more loaded, than that of the model).
CostSample expected_cost(std::span<const CostSample> samples, const CostModel& model, double resolution);

}  // namespace runout
