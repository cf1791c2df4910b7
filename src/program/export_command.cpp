#include <filesystem>
#include <memory>

#include "core/input_error.h"
#include "core/output_folder.h"
#include "core/printable.h"
#include "program/command.h"
#include "program/common_options.h"
#include "program/log.h"
#include "program/run_choice.h"
#include "report/export/export_files.h"
#include "store/store.h"

namespace runout {
namespace {

namespace fs = std::filesystem;

struct ExportArguments {
    RunChoice choice;
    std::string vtk, csv;  ///< folders; empty: not wanted
    OutputRules rules{};
};

std::string path_in(const std::string& folder, const std::string& name) {
    return (fs::path(folder) / file_name_part(name)).string();
}

/// What would only be found out after other files are written.
void check_files(const ExportFiles& files, const std::string& folder, const std::string& option,
                 const OutputRules& rules) {
    for (const auto& [name, text] : files)
        check_output_place(path_in(folder, name), option, Folder::may_be_made, rules);
}

void check_arguments(const ExportArguments& arguments) {
    if (arguments.vtk.empty() && arguments.csv.empty())
        throw InputError({.file = {}, .line = 0, .key = "export", .value = {}}, "says not what to write",
                         "give --vtk FOLDER, --csv FOLDER or both");
}

void write_files(const ExportFiles& files, const std::string& folder, const std::string& option,
                 const OutputRules& rules) {
    if (files.empty()) return;
    make_output_folder(folder, option);
    for (const auto& [name, text] : files) write_output_file(path_in(folder, name), option, text, rules);
    log_info("wrote {} files to {}", files.size(), folder);
}

int export_run(ExportArguments arguments) {
    arguments.rules.taken = database_files(arguments.choice.database);
    check_arguments(arguments);
    const Store store(arguments.choice.database, Store::Mode::read);
    const long run_id = chosen_run(store, arguments.choice);
    const RunData run = read_run_data(store, run_id);
    // All is made before anything is written.
    ExportFiles particles;
    bool from_pictures = false;
    if (!arguments.vtk.empty()) {
        const std::vector<Snapshot> snapshots = store.snapshots(run_id);
        particles = vtk_files(run, snapshots);
        from_pictures = snapshots.empty();
    }
    const ExportFiles tables = arguments.csv.empty() ? ExportFiles{} : csv_files(run);
    check_files(particles, arguments.vtk, "--vtk", arguments.rules);
    check_files(tables, arguments.csv, "--csv", arguments.rules);
    write_files(particles, arguments.vtk, "--vtk", arguments.rules);
    if (from_pictures)
        log_info("from the pictures of the animation: positions to {:.2g} m, {} of {} particles",
                 run.frames.front().scale.x_step_m, run.frames.back().x.size(), run.run.work.particles);
    write_files(tables, arguments.csv, "--csv", arguments.rules);
    return exit_code::success;
}

}  // namespace

void add_export_command(CommandLine& program) {
    const auto arguments = std::make_shared<ExportArguments>();
    Command command = program.add_command("export", "Write a stored run for ParaView and for spreadsheets");
    add_run_choice(command, arguments->choice);
    command
        .add_option("--vtk", &arguments->vtk,
                    "Folder for the particles over time (VTK PolyData, particles.pvd)")
        .value_name("FOLDER");
    command.add_option("--csv", &arguments->csv, "Folder for series.csv and deposit.csv")
        .value_name("FOLDER");
    add_overwrite_option(command, arguments->rules);
    command.set_work([arguments] { return export_run(*arguments); });
}

}  // namespace runout
