#include <fmt/format.h>

#include <memory>

#include "core/input_error.h"
#include "program/command.h"
#include "report/table.h"
#include "store/store.h"

namespace runout {
namespace {

struct TableArguments {
    std::string database;
    std::string format = "text";
};

TableFormat table_format(const std::string& name) {
    if (name == "text") return TableFormat::text;
    if (name == "csv") return TableFormat::csv;
    if (name == "json") return TableFormat::json;
    throw InputError({.file = {}, .line = 0, .key = "--format", .value = name}, "is not known",
                     "valid: text, csv or json");
}

int show_table(const TableArguments& arguments) {
    const TableFormat format = table_format(arguments.format);
    const std::string table = run_table(Store(arguments.database, Store::Mode::read).runs(), format);
    fmt::print("{}{}", table, table.ends_with('\n') ? "" : "\n");
    return exit_code::success;
}

}  // namespace

void add_table_command(CLI::App& app, Command& command) {
    const auto arguments = std::make_shared<TableArguments>();
    CLI::App* sub = app.add_subcommand("table", "List the runs of a database");
    sub->add_option("DB", arguments->database, "Database of runs, such as runout.db")
        ->required()
        ->type_name("");
    sub->add_option("--format", arguments->format, "text, csv or json")
        ->type_name("word")
        ->capture_default_str();
    sub->callback([arguments, &command] { command = [arguments] { return show_table(*arguments); }; });
}

}  // namespace runout
