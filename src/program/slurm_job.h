#pragma once

#include <string>

namespace runout {

/// What a job array has to know.
struct SlurmJob {
    std::string study;
    std::string name;
    std::size_t scenarios = 0;
    double seconds = 0;  ///< CPU time of one scenario
    std::size_t parts = 1;
};

/// A batch script for Slurm: an array of parts, each with a database of its own, with time and memory from
/// what a scenario takes, and how to merge them. Submit it with sbatch where the program is.
std::string slurm_job(const SlurmJob& job);

}  // namespace runout
