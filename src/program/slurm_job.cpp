#include "program/slurm_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace runout {
namespace {

constexpr double safety = 3.0;  // of the expected time: the limit kills
constexpr double least_minutes = 5.0;
constexpr int memory_mb = 1000;  // a run of 100,000 particles takes half of it

/// What the shell leaves as it is.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

/// Slurm takes letters, digits and a few signs for a name.
std::string job_name(const std::string& name) {
    std::string result = "runout-";
    for (const char c : name)
        result += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' ? c : '-';
    return result;
}

}  // namespace

std::string slurm_job(const SlurmJob& job) {
    const double of_a_part = std::ceil(static_cast<double>(job.scenarios) / static_cast<double>(job.parts));
    const double minutes = std::max(least_minutes, std::ceil(safety * of_a_part * job.seconds / 60));
    return fmt::format(
        "#!/bin/bash\n"
        "# {0} scenarios in {1} parts; about {2:.2g} s of CPU time each.\n"
        "# When all have ended: runout merge all.db shard-*.db\n"
        "#SBATCH --job-name={3}\n"
        "#SBATCH --array=0-{4}\n"
        "#SBATCH --ntasks=1\n"
        "#SBATCH --cpus-per-task=1\n"
        "#SBATCH --mem={5}M\n"
        "#SBATCH --time={6:.0f}\n"
        "# A part that was killed goes on where it stood when it is submitted again.\n"
        "set -u\n"
        "\"${{RUNOUT:-runout}}\" sweep {7} -j 1 --quiet \\\n"
        "    --shard \"$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT\" --db "
        "\"shard-$SLURM_ARRAY_TASK_ID.db\"\n",
        job.scenarios, job.parts, job.seconds, job_name(job.name), job.parts - 1, memory_mb, minutes,
        quoted(job.study));
}

}  // namespace runout
