#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

#include "core/input_error.h"
#include "core/printable.h"
#include "core/version.h"
#include "engine/simd/instruction_set.h"
#include "gis/network.h"
#include "program/command.h"
#include "program/log.h"

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

int fail(int code, const std::string& kind, const std::string& sentence) {
    fmt::print(stderr, "runout: {}: {}\n", kind, printable(sentence));
    return code;
}

int run_program(int argc, char** argv) {
    CommandLine program(
        "runout",
        "How far does a failing cut slope run? Takes a cross-section, derives the source mass, simulates "
        "its\n"
        "run-out with incompressible SPH, prints the answer and stores it.\n");
    program.set_version(version_text());
    program.add_flag("--allow-network", allow_network,
                     "Let maps and rasters lie on other machines, and virtual rasters refer to any file");
    program.set_footer(examples);
    add_run_command(program);
    add_new_command(program);
    add_profile_command(program);
    add_source_command(program);
    add_effects_command(program);
    add_barrier_command(program);
    add_sweep_command(program);
    add_merge_command(program);
    add_delete_command(program);
    add_table_command(program);
    add_at_command(program);
    add_estimate_command(program);
    add_accuracy_command(program);
    add_map_command(program);
    add_report_command(program);
    add_compare_command(program);
    add_export_command(program);
    add_back_analysis_command(program);
    add_validate_command(program);
    add_stress_command(program);
    add_help_command(program);
    return program.run(argc, argv);
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
        start_log();
        return after_flush(run_program(argc, argv));
    } catch (const UsageError& error) {
        return fail(exit_code::input_error, "error", error.what());
    } catch (const InputError& error) {
        return fail(exit_code::input_error, "error", error.what());
    } catch (const std::bad_alloc&) {
        return fail(exit_code::internal_error, "error",
                    "the memory does not suffice; run coarser, or fewer runs at a time");
    } catch (const std::exception& error) {
        return fail(exit_code::internal_error, "internal error", error.what());
    }
}
