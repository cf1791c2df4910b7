#include "program/jobs_option.h"

#include <algorithm>
#include <thread>

#include "program/number_option.h"

namespace runout {

int default_jobs() {
    return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

void add_jobs_option(CLI::App& command, int& jobs) {
    add_number_option(command, "-j,--jobs", jobs, "Runs at a time, each on one thread", {1, 1024});
}

}  // namespace runout
