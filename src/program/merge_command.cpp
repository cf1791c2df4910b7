#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <vector>

#include "core/input_error.h"
#include "core/printable.h"
#include "program/answer.h"
#include "program/command.h"
#include "program/log.h"
#include "store/database.h"
#include "store/store.h"

namespace runout {
namespace {

struct MergeArguments {
    std::string into;
    std::vector<std::string> from;
};

void tell(const std::string& path, const MergeCounts& counts) {
    print_text(fmt::format("{}: {} runs added, {} known already, {} studies\n", printable(path),
                           counts.runs_added, counts.runs_known, counts.studies));
    std::fflush(stdout);
    for (const std::string& object : counts.foreign)
        log_warning("{} holds {} {} that is not Runout's; it was left there", path,
                    object.starts_with("index") ? "an" : "a", object);
    if (counts.lacks_log)
        log_warning(
            "{0} says that it is written through a log, and there is no {0}-wal beside it: runs may be "
            "missing. If "
            "it was copied, copy {0}-wal too and merge again",
            path);
}

int merge(const MergeArguments& arguments) {
    for (const std::string& path : arguments.from) check_whole(path);  // all, before any is copied
    Store store(arguments.into, Store::Mode::write);
    bool complete = true;
    std::size_t merged = 0;
    try {
        for (const std::string& path : arguments.from) {
            const MergeCounts counts = store.merge(path);
            tell(path, counts);
            complete = complete && !counts.lacks_log;
            ++merged;
        }
    } catch (const InputError& error) {
        if (merged == 0) throw;
        // What was merged stays, each database whole, and may be merged again.
        log_error("{}; the {} before it are merged, it and those after it are not", error.what(), merged);
        return exit_code::not_a_result;
    }
    return complete ? exit_code::success : exit_code::not_a_result;
}

}  // namespace

void add_merge_command(CommandLine& program) {
    const auto arguments = std::make_shared<MergeArguments>();
    Command command = program.add_command("merge", "Bring the runs of several databases into one");
    command.add_option("INTO", &arguments->into, "Database that takes them; made if absent")
        .required()
        .value_name("");
    command.add_option("FROM", &arguments->from, "Databases to read, such as shard-*.db")
        .required()
        .value_name("");
    command.set_work([arguments] { return merge(*arguments); });
}

}  // namespace runout
