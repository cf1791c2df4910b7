#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "core/input_error.h"
#include "core/output_file.h"
#include "core/printable.h"
#include "program/answer.h"
#include "program/case_arguments.h"
#include "program/command.h"
#include "program/log.h"
#include "scene/new_case.h"

namespace runout {
namespace {

namespace fs = std::filesystem;

struct NewArguments {
    CaseArguments scenario;
    std::string output;
};

void check_place(const std::string& output) {
    std::error_code ignored;
    if (fs::is_regular_file(output, ignored))
        throw InputError({"--output", 0, "", output}, "exists already", "give the name of a new file");
    check_output_place(output, "--output");
}

int write_new_case(const NewArguments& arguments) {
    if (!arguments.output.empty()) check_place(arguments.output);
    const CaseSpec spec = case_from(arguments.scenario);
    if (!spec.has("section.file") && !spec.has("section.line"))
        throw InputError({spec.file, 0, "", ""}, "is not a section", "give a section file or lines on a map");
    if (fs::path(spec.file).extension() == ".toml")
        throw InputError({spec.file, 0, "", ""}, "is a case already",
                         "give the section that a case is to be made of");
    const fs::path folder = arguments.output.empty() ? "." : fs::absolute(arguments.output).parent_path();
    const NewCase made = new_case(spec, folder.string());
    if (!is_utf8(made.text))
        throw InputError({spec.file, 0, "", ""}, "has a name that is no UTF-8, which a case file cannot hold",
                         "rename it");
    if (made.example_friction)
        log_warning("material.friction_angle_deg = 38 is an example; give that of the soil");
    if (arguments.output.empty()) {
        print_text(made.text);
        return exit_code::success;
    }
    write_output_file(arguments.output, "--output", made.text);
    print_text(fmt::format("{} is a case with {} and a source of type {}; next: runout run {}\n",
                           printable(arguments.output), printable(spec.file), to_string(made.source_type),
                           printable(arguments.output)));
    return exit_code::success;
}

}  // namespace

void add_new_command(CommandLine& program) {
    const auto arguments = std::make_shared<NewArguments>();
    Command command = program.add_command("new", "Write a case with explained keys from a section");
    add_case_arguments(command, arguments->scenario).required();
    command
        .add_option("-o,--output", &arguments->output, "File to write; standard output when it is not given")
        .value_name("PATH")
        .group("Output");
    command.set_work([arguments] { return write_new_case(*arguments); });
}

}  // namespace runout
