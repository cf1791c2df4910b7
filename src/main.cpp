#include <fcntl.h>
#include <fmt/format.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <memory>
#include <new>
#include <string_view>

#include "core/input_error.h"
#include "core/printable.h"
#include "core/version.h"
#include "engine/simd/instruction_set.h"
#include "gis/network.h"
#include "program/command.h"

namespace {

using namespace runout;

constexpr const char* examples = R"(Examples:
  runout run cases/box-70/case.toml
  runout run section.csv --source B --base-angle 35 --scarp-angle 80 --friction-angle 38
  runout run case.toml --set material.friction_angle_deg=35 --db study.db --json
  runout new section.dxf -o case.toml
  runout source section.csv --source C --height 12 --area 60
  runout effects case.toml
  runout table runout.db --format csv
  runout delete runout.db --older-than 90d
  runout sweep study.toml --db sweep.db
  runout estimate sweep.db --slope-angle 60 --drop-height 3 --front-area 0.2 --friction-angle 35
  runout accuracy cases/box-70/case.toml --target 5%
  runout profile sections.gpkg --raster dem.tif
  runout map runout.db -o results.gpkg
  runout report runout.db --run 3 -o report.html
  runout compare runout.db --width 20
  runout validate --quick
  runout stress --scenes 200 --range slope_angle_deg=50:70
  runout help keys

Exit codes: 0 settled or stable, 1 ended otherwise or some lines refused, 2 wrong input (nothing written),
3 internal error, 4 stored elsewhere (the database was in use; runout merge brings the side database in),
130 interrupted.)";

std::string version_text() {
    return fmt::format("runout {} (revision {}, {}, {} instructions)", program_version(), program_revision(),
                       compiler_description(), to_string(instruction_set()));
}

/// The message of a log line, as printable() shows it.
class PrintableMessage : public spdlog::custom_flag_formatter {
  public:
    void format(const spdlog::details::log_msg& message, const std::tm&,
                spdlog::memory_buf_t& line) override {
        const std::string text = printable({message.payload.data(), message.payload.size()});
        line.append(text.data(), text.data() + text.size());
    }
    [[nodiscard]] std::unique_ptr<custom_flag_formatter> clone() const override {
        return std::make_unique<PrintableMessage>();
    }
};

/// Standard output belongs to the answer.
void log_to_stderr() {
    auto logger = spdlog::stderr_color_mt("runout");
    auto lines = std::make_unique<spdlog::pattern_formatter>();
    lines->add_flag<PrintableMessage>('*').set_pattern("runout: %^%l%$: %*");
    logger->set_formatter(std::move(lines));
    spdlog::set_default_logger(logger);
}

int fail(int code, const std::string& kind, const std::string& sentence) {
    fmt::print(stderr, "runout: {}: {}\n", kind, printable(sentence));
    return code;
}

bool names_no_subcommand(const CLI::App& app, const std::string& word) {
    return !word.starts_with('-') &&
           app.get_subcommands([&](const CLI::App* sub) { return sub->get_name() == word; }).empty();
}

std::string known_subcommands(const CLI::App& app) {
    std::string names;
    for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
        names += (names.empty() ? "" : ", ") + sub->get_name();
    return names;
}

int parse_failure(const CLI::App& app, const CLI::ParseError& error, const std::string& first_word) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help and --version
    if (!first_word.empty() && names_no_subcommand(app, first_word))
        return fail(exit_code::input_error, "error",
                    fmt::format("{} is not a subcommand; known are {}", first_word, known_subcommands(app)));
    return fail(exit_code::input_error, "error", fmt::format("{}; see runout --help", error.what()));
}

/// "-o=page.html" would write a file of the name "=page.html".
void refuse_short_assignments(int argc, char** argv) {
    for (int i = 1; i < argc && std::string_view(argv[i]) != "--"; ++i) {
        const std::string word = argv[i];
        if (word.size() < 3 || word[0] != '-' || word[1] == '-' || word[2] != '=') continue;
        throw InputError({.file = {}, .line = 0, .key = {}, .value = word},
                         "has = after an option of one letter",
                         fmt::format("write {} {}", word.substr(0, 2), word.substr(3)));
    }
}

/// As of a variable of the shell that is not set: it says nothing, and is no name of a file.
void refuse_empty_values(CLI::App& app) {
    const auto check = [](const std::string& value) {
        return value.empty() ? std::string("is empty; give a value, or leave it out") : std::string();
    };
    for (CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
        for (CLI::Option* option : sub->get_options())
            if (option->get_items_expected_max() > 0) option->check(check);
}

int run_program(int argc, char** argv) {
    CLI::App app(
        "How far does a failing cut slope run? Takes a cross-section, derives the source mass, simulates "
        "its\n"
        "run-out with incompressible SPH, prints the answer and stores it.\n",
        "runout");
    app.set_version_flag("--version", version_text());
    app.require_subcommand(1);
    app.fallthrough();  // options of the program may follow those of a subcommand
    app.add_flag_callback(
        "--allow-network", allow_network,
        "Let maps and rasters lie on other machines, and virtual rasters refer to any file");
    app.footer(examples);

    Command command;
    add_run_command(app, command);
    add_new_command(app, command);
    add_profile_command(app, command);
    add_source_command(app, command);
    add_effects_command(app, command);
    add_sweep_command(app, command);
    add_merge_command(app, command);
    add_delete_command(app, command);
    add_table_command(app, command);
    add_estimate_command(app, command);
    add_accuracy_command(app, command);
    add_map_command(app, command);
    add_report_command(app, command);
    add_compare_command(app, command);
    add_export_command(app, command);
    add_back_analysis_command(app, command);
    add_validate_command(app, command);
    add_stress_command(app, command);
    add_help_command(app, command);
    refuse_empty_values(app);
    refuse_short_assignments(argc, argv);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return parse_failure(app, error, argc > 1 ? argv[1] : "");
    }
    return command();
}

/// A stream that the shell closed would be the next file that is opened, and the answer would go into it.
void open_closed_streams() {
    for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream)
        if (fcntl(stream, F_GETFD) < 0) (void)open("/dev/null", O_RDWR);
}

/// A file that grows beyond a limit of the shell (ulimit -f) is a disk that is full: the write that fails is
/// told.
void let_writes_fail() {
    std::signal(SIGXFSZ, SIG_IGN);
}

/// An answer that did not get out is none.
int after_flush(int code) {
    const bool written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
    if (written) return code;
    return fail(exit_code::input_error, "error",
                "standard output cannot be written; check where it goes and free space");
}

}  // namespace

int main(int argc, char** argv) {
    open_closed_streams();
    let_writes_fail();
    try {
        log_to_stderr();
        return after_flush(run_program(argc, argv));
    } catch (const InputError& error) {
        return fail(exit_code::input_error, "error", error.what());
    } catch (const std::bad_alloc&) {
        return fail(exit_code::internal_error, "error",
                    "the memory does not suffice; run coarser, or fewer runs at a time");
    } catch (const std::exception& error) {
        return fail(exit_code::internal_error, "internal error", error.what());
    }
}
