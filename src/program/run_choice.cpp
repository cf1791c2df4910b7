#include "program/run_choice.h"

#include "core/input_error.h"
#include "program/common_options.h"
#include "program/number_option.h"

namespace runout {

void add_run_choice(Command& command, RunChoice& choice) {
    add_database_argument(command, choice.database);
    add_id_option(command, "--run", choice.run_id, "Number of the run; the last result if none is given");
}

void add_width_option(Command& command, double& width) {
    add_number_option(
        command, "--width", width,
        "Width of the slide across the section: area times width is the volume that most relations ask for",
        {1e-3, 1e6})
        .value_name("m");
}

long chosen_run(const Store& store, const RunChoice& choice) {
    if (choice.run_id) return *choice.run_id;
    const std::vector<StoredRun> runs = store.runs();
    if (runs.empty())
        throw InputError({.file = choice.database, .line = 0, .key = {}, .value = {}}, "holds no runs",
                         "store one first: runout run CASE --db " + choice.database);
    for (auto run = runs.rbegin(); run != runs.rend(); ++run)
        if (is_result(run->status)) return run->run_id;
    return runs.back().run_id;
}

}  // namespace runout
