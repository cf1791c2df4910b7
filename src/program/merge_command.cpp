#include <fmt/format.h>

#include <memory>
#include <vector>

#include "program/command.h"
#include "store/store.h"

namespace runout {
namespace {

struct MergeArguments {
    std::string into;
    std::vector<std::string> from;
};

int merge(const MergeArguments& arguments) {
    for (const std::string& path : arguments.from)
        Store(path, Store::Mode::read);  // all, before any is copied
    Store store(arguments.into, Store::Mode::write);
    for (const std::string& path : arguments.from) {
        const MergeCounts counts = store.merge(path);
        fmt::print("{}: {} runs added, {} known already, {} studies\n", path, counts.runs_added,
                   counts.runs_known, counts.studies);
    }
    return exit_code::success;
}

}  // namespace

void add_merge_command(CLI::App& app, Command& command) {
    const auto arguments = std::make_shared<MergeArguments>();
    CLI::App* sub = app.add_subcommand("merge", "Bring the runs of several databases into one");
    sub->add_option("INTO", arguments->into, "Database that takes them; made if absent")
        ->required()
        ->type_name("");
    sub->add_option("FROM", arguments->from, "Databases to read, such as shard-*.db")
        ->required()
        ->type_name("");
    sub->callback([arguments, &command] { command = [arguments] { return merge(*arguments); }; });
}

}  // namespace runout
