#include <spdlog/spdlog.h>

#include <filesystem>
#include <memory>

#include "core/input_error.h"
#include "program/command.h"
#include "program/output_file.h"
#include "program/run_choice.h"
#include "report/export_files.h"
#include "store/store.h"

namespace runout {
namespace {

namespace fs = std::filesystem;

struct ExportArguments {
    RunChoice choice;
    std::string vtk, csv;  ///< folders; empty: not wanted
};

void check_arguments(const ExportArguments& arguments) {
    if (arguments.vtk.empty() && arguments.csv.empty())
        throw InputError({.file = {}, .line = 0, .key = "export", .value = {}}, "says not what to write",
                         "give --vtk FOLDER, --csv FOLDER or both");
    for (const auto& [option, folder] :
         {std::pair{"--vtk", arguments.vtk}, std::pair{"--csv", arguments.csv}})
        if (!folder.empty()) check_output_place(folder + "/x", option, Folder::may_be_made);
}

void write_files(const ExportFiles& files, const std::string& folder, const std::string& option) {
    fs::create_directories(folder);
    for (const auto& [name, text] : files)
        write_output_file((fs::path(folder) / name).string(), option, text);
    spdlog::info("wrote {} files to {}", files.size(), folder);
}

int export_run(const ExportArguments& arguments) {
    check_arguments(arguments);
    const Store store(arguments.choice.database, Store::Mode::read);
    const long run_id = chosen_run(store, arguments.choice);
    const RunData run = read_run_data(store, run_id);
    // All is made before anything is written.
    ExportFiles particles;
    if (!arguments.vtk.empty()) {
        const std::vector<Snapshot> snapshots = store.snapshots(run_id);
        particles = vtk_files(run, snapshots);
        if (snapshots.empty())
            spdlog::info("from the pictures of the animation: positions to {:.2g} m, {} of {} particles",
                         run.frames.front().scale.x_step_m, run.frames.back().x.size(),
                         run.run.work.particles);
    }
    if (!arguments.vtk.empty()) write_files(particles, arguments.vtk, "--vtk");
    if (!arguments.csv.empty()) write_files(csv_files(run), arguments.csv, "--csv");
    return exit_code::success;
}

}  // namespace

void add_export_command(CLI::App& app, Command& command) {
    const auto arguments = std::make_shared<ExportArguments>();
    CLI::App* sub = app.add_subcommand("export", "Write a stored run for ParaView and for spreadsheets");
    add_run_choice(*sub, arguments->choice);
    sub->add_option("--vtk", arguments->vtk,
                    "Folder for the particles over time (VTK PolyData, particles.pvd)")
        ->type_name("FOLDER");
    sub->add_option("--csv", arguments->csv, "Folder for series.csv and deposit.csv")->type_name("FOLDER");
    sub->callback([arguments, &command] { command = [arguments] { return export_run(*arguments); }; });
}

}  // namespace runout
