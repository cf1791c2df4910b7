#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <filesystem>
#include <memory>

#include "core/input_error.h"
#include "program/command.h"
#include "report/result_map.h"

namespace runout {
namespace {

struct MapArguments {
    std::string database;
    std::string output;
    std::string crs;
    MapOptions options;
    bool overwrite = false;
};

void check_output(const MapArguments& arguments) {
    check_map_path(arguments.output, arguments.crs);
    if (!arguments.overwrite && std::filesystem::exists(arguments.output))
        throw InputError({"", 0, "--output", arguments.output}, "exists",
                         "give another name, or --overwrite");
}

int make_map(const MapArguments& arguments) {
    check_output(arguments);
    const ResultMap map = result_map(Store(arguments.database, Store::Mode::read), arguments.options);
    write_map(arguments.output, map.sheet, arguments.crs);
    for (const std::string& remark : map.remarks) spdlog::warn("{}", remark);
    for (const MapLayer& layer : map.sheet.layers)
        if (!layer.features.empty())
            fmt::print("{:<24}{:>6}  {}\n", layer.name, layer.features.size(), layer.title);
    return exit_code::success;
}

}  // namespace

void add_map_command(CLI::App& app, Command& command) {
    const auto arguments = std::make_shared<MapArguments>();
    CLI::App* sub = app.add_subcommand("map", "Write the results as layers for a GIS");
    sub->add_option("DB", arguments->database, "Database of runs, such as runout.db")
        ->required()
        ->type_name("");
    sub->add_option("-o,--output", arguments->output, "The map: .gpkg (with styles for QGIS) or .geojson")
        ->required()
        ->type_name("PATH");
    sub->add_option("--crs", arguments->crs,
                    "Coordinate system of a .gpkg, such as EPSG:2326 (default: that of the first section)")
        ->type_name("NAME");
    sub->add_option("--neighbours-within", arguments->options.neighbours_within_m,
                    "Toes of neighbouring sections, which a hazard band joins, are no farther apart")
        ->type_name("m")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    sub->add_flag("--every-run", arguments->options.every_run, "Not only the finest run of each question");
    sub->add_flag("--overwrite", arguments->overwrite, "Replace the file if it exists");
    sub->callback([arguments, &command] { command = [arguments] { return make_map(*arguments); }; });
}

}  // namespace runout
