#include <fmt/format.h>

#include <memory>

#include "core/printable.h"
#include "program/answer.h"
#include "program/command.h"
#include "program/common_options.h"
#include "program/log.h"
#include "program/number_option.h"
#include "report/map/result_map.h"

namespace runout {
namespace {

struct MapArguments {
    std::string database;
    std::string output;
    std::string crs;
    MapOptions options;
    std::vector<std::string> intensities;
    OutputRules rules{};
};

int make_map(MapArguments arguments) {
    arguments.rules.taken = database_files(arguments.database);
    check_map_path(arguments.output, arguments.crs, arguments.rules);
    arguments.options.intensities = intensities_from(arguments.intensities, "--intensity");
    const ResultMap map = result_map(Store(arguments.database, Store::Mode::read), arguments.options);
    write_map(arguments.output, map.sheet, arguments.crs, arguments.rules);
    for (const std::string& remark : map.remarks) log_warning("{}", remark);
    for (const MapLayer& layer : map.sheet.layers)
        if (!layer.features.empty())
            print_text(fmt::format("{:<24}{:>6}  {}\n", printable(layer.name), layer.features.size(),
                                   printable(layer.title)));
    return exit_code::success;
}

}  // namespace

void add_map_command(CommandLine& program) {
    const auto arguments = std::make_shared<MapArguments>();
    Command command = program.add_command("map", "Write the results as layers for a GIS");
    add_database_argument(command, arguments->database);
    command.add_option("-o,--output", &arguments->output, "The map: .gpkg (with styles for QGIS) or .geojson")
        .required()
        .value_name("PATH");
    command
        .add_option("--crs", &arguments->crs,
                    "Coordinate system of a .gpkg, such as EPSG:2326 (default: that of the first section)")
        .value_name("NAME");
    add_number_option(command, "--neighbours-within", arguments->options.neighbours_within_m,
                      "Toes of neighbouring sections, which a hazard band joins, are no farther apart",
                      positive_number)
        .value_name("m");
    command.add_flag("--every-run", &arguments->options.every_run,
                     "Not only the finest run of each question");
    add_intensity_option(command, arguments->intensities);
    add_overwrite_option(command, arguments->rules);
    command.set_work([arguments] { return make_map(*arguments); });
}

}  // namespace runout
