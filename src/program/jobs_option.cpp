#include "program/jobs_option.h"

#include <algorithm>
#include <thread>

namespace runout {

int default_jobs() {
    return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

void add_jobs_option(CLI::App& command, int& jobs) {
    command.add_option("-j,--jobs", jobs, "Runs at a time, each on one thread")
        ->type_name("number")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
}

}  // namespace runout
