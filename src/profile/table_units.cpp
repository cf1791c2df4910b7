#include "profile/table_units.h"

#include <fmt/format.h>

#include "core/input_error.h"
#include "profile/table_numbers.h"

namespace runout {
namespace {

constexpr const char* give_unit = "give --unit m, ft or us-ft (section.unit)";

InputPlace place_of(const TableReading& reading, const std::string& name) {
    return {reading.path, 0, "header", name};
}

void refuse_strange_unit(const TableReading& reading, const TableColumn& column) {
    if (column.name.strange_unit)
        throw InputError(place_of(reading, column.name.text), "names a unit that is not known, or two",
                         give_unit);
}

/// One column that says feet, and one that says nothing: both may be meant, or not.
void refuse_feet_of_one_column(const TableReading& reading) {
    const ColumnName& chainage = reading.layout.chainage.name;
    const ColumnName& elevation = reading.layout.elevation.name;
    if (chainage.unit.has_value() == elevation.unit.has_value()) return;
    const ColumnName& said = chainage.unit ? chainage : elevation;
    const ColumnName& silent = chainage.unit ? elevation : chainage;
    if (said.unit->metres == 1) return;
    throw InputError(place_of(reading, silent.text), fmt::format("names no unit beside '{}'", said.text),
                     "name it in the header, or " + std::string(give_unit));
}

void refuse_feet_of_title(const TableReading& reading) {
    const TableLayout& layout = reading.layout;
    if (layout.titles_mention_feet && !layout.chainage.name.unit && !layout.elevation.name.unit)
        throw InputError({reading.path, 0, "", ""},
                         "speaks of feet above its points, but no column says its unit", give_unit);
}

TableUnits units_of_header(const TableReading& reading, bool stations_of_100) {
    refuse_strange_unit(reading, reading.layout.chainage);
    refuse_strange_unit(reading, reading.layout.elevation);
    const LengthUnit metre = *length_unit("m");
    const auto& chainage = reading.layout.chainage.name.unit;
    const LengthUnit elevation = reading.layout.elevation.name.unit.value_or(metre);
    // Stations of 100 are feet wherever they are written.
    if (!chainage && stations_of_100 && elevation.is_foot()) return {elevation, elevation, std::nullopt, {}};
    refuse_feet_of_one_column(reading);
    refuse_feet_of_title(reading);
    return {chainage.value_or(metre), elevation, std::nullopt, {}};
}

bool is_said(const TableReading& reading) {
    return !reading.options.unit.empty() || reading.layout.chainage.name.unit ||
           reading.layout.elevation.name.unit;
}

/// Three digits behind the plus are metres of a kilometre, two are feet of a station of 100 ft.
void check_stations(const TableReading& reading, const TableUnits& units, const PointCells& first) {
    const InputPlace place{reading.path, first.line, reading.layout.chainage.name.text,
                           std::string(first.chainage)};
    const bool metric = *units.station_digits == 3;
    if (metric && units.chainage.metres != 1)
        throw InputError(place, fmt::format("is a station of 1000, but the unit is {}", units.chainage.name),
                         "write the chainage as a plain number");
    if (metric || units.chainage.is_foot()) return;
    throw InputError(
        place, "is a station of 100 of a unit, and metres have stations of 1000",
        "give --unit ft (section.unit) if these are feet, else write the chainage as a plain number");
}

std::string text_of(const TableUnits& units, bool said) {
    const std::string stations =
        units.station_digits ? fmt::format("stations of {}, ", *units.station_digits == 3 ? 1000 : 100) : "";
    if (units.chainage.metres != units.elevation.metres)
        return fmt::format("{}chainage in {}, elevation in {}", stations, units.chainage.name,
                           units.elevation.name);
    return fmt::format("{}{}{}", stations, units.chainage.name, said ? "" : " as no unit is named");
}

}  // namespace

TableUnits table_units(const TableReading& reading, const std::vector<PointCells>& points) {
    const auto station = station_text(points.front().chainage);
    const std::string& word = reading.options.unit;
    const LengthUnit wanted = known_length_unit(word.empty() ? "m" : word);
    TableUnits units{wanted, wanted, std::nullopt, {}};
    if (word.empty()) units = units_of_header(reading, station && station->digits_after == 2);
    if (station) {
        units.station_digits = station->digits_after;
        check_stations(reading, units, points.front());
    }
    units.text = text_of(units, is_said(reading));
    return units;
}

}  // namespace runout
