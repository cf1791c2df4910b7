#include "program/common_options.h"

#include <algorithm>
#include <thread>

#include "program/number_option.h"

namespace runout {

InputPlace option_place(const std::string& option, const std::string& value) {
    return {.file = option, .line = 0, .key = {}, .value = value};
}

void add_database_argument(Command& command, std::string& path) {
    command.add_option("DB", &path, "Database of runs, such as runout.db").required().value_name("");
}

CommandOption add_database_option(Command& command, std::string& path) {
    return command.add_option("--db", &path, "Database that takes the runs; what it holds is not repeated")
        .value_name("PATH")
        .show_default();
}

int default_jobs() {
    return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

void add_jobs_option(Command& command, int& jobs) {
    add_number_option(command, "-j,--jobs", jobs, "Runs at a time, each on one thread", {1, 1024});
}

CommandOption add_intensity_option(Command& command, std::vector<std::string>& classes) {
    return command
        .add_option("--intensity", &classes,
                    "A class of intensity, thicker and faster than this; the least first (docs/front.md)")
        .value_name("NAME=m,m/s")
        .one_value_a_use();
}

void add_overwrite_option(Command& command, OutputRules& rules) {
    command
        .add_flag("--overwrite", &rules.overwrite,
                  "Replace files that exist, also such as this program did not write or that were edited")
        .group("Output");
}

}  // namespace runout
