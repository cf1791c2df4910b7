#include "report/map/result_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/input_error.h"
#include "report/map/map_styles.h"
#include "report/text/intensity.h"
#include "report/text/place_doubt.h"

namespace runout {
namespace {

constexpr Colour ochre{223, 194, 125};
constexpr Colour red{215, 25, 28};
constexpr Colour grey{120, 120, 120};
constexpr Colour magenta{197, 27, 125};

/// Section and run only, for layers with many features.
std::vector<Attribute> short_attributes(const MapRun& run) {
    std::vector<Attribute> few;
    for (const Attribute& attribute : run.attributes) {
        const bool of_section = attribute.name.starts_with("section_") && attribute.name != "section_origin";
        if (of_section || attribute.name == "run_id" || attribute.name == "name" ||
            attribute.name == "friction_angle_deg")
            few.push_back(attribute);
    }
    return few;
}

bool has_moved(const MapRun& run) {
    return run.run.status == RunStatus::settled;
}

/// Classes of thickness from pale to dark.
std::vector<ColourClass> thickness_classes() {
    return {{0, 0.25, "up to 0.25 m", {255, 255, 178}}, {0.25, 0.5, "0.25 to 0.5 m", {254, 217, 118}},
            {0.5, 1, "0.5 to 1 m", {253, 141, 60}},     {1, 2, "1 to 2 m", {240, 59, 32}},
            {2, 5, "2 to 5 m", {189, 0, 38}},           {5, 1000, "more than 5 m", {84, 0, 30}}};
}

/// The points of a line in the system of the map; none where it has none there.
Polyline drawn_in(const MapLine& line, const std::string& crs) {
    if (line.points.empty()) return {};
    try {
        return in_system(line, crs).points;
    } catch (const InputError&) {
        return {};
    }
}

}  // namespace

MapLayer section_layer(const MapRuns& runs) {
    MapLayer layer{"section", "Section lines", GeometryKind::line, {}, line_style(grey, 0.3)};
    std::set<std::string> drawn;
    for (const MapRun& run : runs.runs) {
        MapFeature feature{run.place.line.points, {}};
        std::string key;
        for (const Vec2& point : feature.points) key += fmt::format("{} {};", point.x(), point.y());
        for (const Attribute& attribute : run.run.section_attributes) {
            feature.attributes.push_back({"section_" + attribute.name, attribute.value});
            key += text_of(attribute.value) + ";";
        }
        if (!drawn.insert(key).second) continue;
        feature.attributes.push_back({"section_origin", run.run.section_origin});
        feature.attributes.push_back({"slope_angle_deg", run.run.slope_angle_deg});
        feature.attributes.push_back(
            {"length_m", run.place.line.chainage_m.back() - run.place.line.chainage_m.front()});
        layer.features.push_back(std::move(feature));
    }
    return layer;
}

MapLayer source_layer(const MapRuns& runs) {
    MapLayer layer{"source",
                   "Source of the landslide along the section",
                   GeometryKind::line,
                   {},
                   line_style(magenta, 1.6)};
    for (const MapRun& run : runs.runs) {
        double low = run.place.head.x();
        double high = low;
        for (const Vec2& point : run.place.source_outline) {
            low = std::min(low, point.x());
            high = std::max(high, point.x());
        }
        MapFeature feature{part_between(run.place.line, low, high), run.attributes};
        feature.attributes.push_back({"from_chainage_m", low});
        feature.attributes.push_back({"to_chainage_m", high});
        layer.features.push_back(std::move(feature));
    }
    return layer;
}

MapLayer deposit_layer(const MapRuns& runs) {
    MapLayer layer{"deposit", "Deposit along the section", GeometryKind::line, {}, line_style(ochre, 2.6)};
    for (const MapRun& run : runs.runs) {
        if (!has_moved(run) || run.deposit.empty()) continue;
        const double from = run.deposit.front().chainage_m;
        const double to = run.deposit.back().chainage_m;
        MapFeature feature{part_between(run.place.line, from, to), run.attributes};
        feature.attributes.push_back({"from_chainage_m", from});
        feature.attributes.push_back({"to_chainage_m", to});
        layer.features.push_back(std::move(feature));
    }
    return layer;
}

MapLayer thickness_layer(const MapRuns& runs) {
    MapLayer layer{"thickness",
                   "Thickness of the deposit",
                   GeometryKind::line,
                   {},
                   graduated_line_style("thickness_by_top_m", thickness_classes(), 1.6)};
    for (const MapRun& run : runs.runs) {
        if (!has_moved(run) || run.deposit.size() < 2) continue;
        const double half = (run.deposit[1].chainage_m - run.deposit[0].chainage_m) / 2;
        for (const DepositRow& row : run.deposit) {
            MapFeature feature{part_between(run.place.line, row.chainage_m - half, row.chainage_m + half),
                               short_attributes(run)};
            feature.attributes.push_back({"chainage_m", row.chainage_m});
            feature.attributes.push_back({"bed_elevation_m", row.bed_elevation_m});
            feature.attributes.push_back({"thickness_by_top_m", row.thickness_by_top_m});
            feature.attributes.push_back({"thickness_by_mass_m", row.thickness_by_mass_m});
            layer.features.push_back(std::move(feature));
        }
    }
    return layer;
}

namespace {

/// From orange for the least class to dark red for the greatest.
std::vector<ColourClass> intensity_colours(const std::vector<IntensityClass>& classes) {
    std::vector<ColourClass> colours;
    const auto last = static_cast<double>(classes.size() - 1);
    for (std::size_t i = 0; i < classes.size(); ++i) {
        const double rank = static_cast<double>(i) + 1;
        const double share = last > 0 ? static_cast<double>(i) / last : 1;
        const auto between = [&](int least, int greatest) {
            return static_cast<int>(std::lround(least + share * (greatest - least)));
        };
        colours.push_back(
            {rank - 0.5, rank + 0.5, classes[i].name, {between(253, 189), between(141, 0), between(60, 38)}});
    }
    return colours;
}

/// 1 for the least class.
long rank_of(const std::vector<IntensityClass>& classes, const std::string& name) {
    return std::ranges::find(classes, name, &IntensityClass::name) - classes.begin() + 1;
}

}  // namespace

MapLayer intensity_layer(const MapRuns& runs, const Intensities& intensities) {
    MapLayer layer{"intensity",
                   intensities.origin,
                   GeometryKind::line,
                   {},
                   graduated_line_style("rank", intensity_colours(intensities.classes), 2.2)};
    for (const MapRun& run : runs.runs) {
        if (!has_moved(run) || !run.envelope) continue;
        const double sign = run.place.descends_with_chainage ? 1.0 : -1.0;
        for (const IntensityStretch& stretch :
             intensity_stretches(*run.envelope, run.run.measures.front_thickness_m, intensities.classes)) {
            const auto [from, to] = std::minmax({run.place.toe_chainage_m + sign * stretch.from_m,
                                                 run.place.toe_chainage_m + sign * stretch.to_m});
            MapFeature feature{part_between(run.place.line, from, to), short_attributes(run)};
            feature.attributes.push_back({"intensity", stretch.name});
            feature.attributes.push_back({"rank", rank_of(intensities.classes, stretch.name)});
            feature.attributes.push_back({"from_m", stretch.from_m});
            feature.attributes.push_back({"to_m", stretch.to_m});
            layer.features.push_back(std::move(feature));
        }
    }
    return layer;
}

MapLayer extent_layer(const MapRuns& runs) {
    MapLayer layer{"runout_extent",
                   "Distal margin of the debris",
                   GeometryKind::point,
                   {},
                   point_style(red, 2.2, "format_number(\"run_out_m\", 1) || ' m'")};
    for (const MapRun& run : runs.runs) {
        if (!has_moved(run)) continue;
        const double chainage = distal_chainage(run);
        MapFeature feature{{point_at(run.place.line, chainage)}, run.attributes};
        feature.attributes.push_back({"chainage_m", chainage});
        layer.features.push_back(std::move(feature));
    }
    return layer;
}

MapLayer extent_line_layer(const MapRuns& runs, const MapMetric& metric) {
    MapLayer layer{"runout_extent_line",
                   "Distal margin, a bar of sqrt(S) to either side",
                   GeometryKind::line,
                   {},
                   line_style(red, 0.6)};
    for (const MapRun& run : runs.runs) {
        if (!has_moved(run)) continue;
        const double chainage = distal_chainage(run);
        MapFeature feature{
            bar_across(run.place.line, metric, chainage, std::sqrt(run.run.measures.source_area_m2)),
            run.attributes};
        feature.attributes.push_back({"chainage_m", chainage});
        layer.features.push_back(std::move(feature));
    }
    return layer;
}

MapLayer place_layer(const MapRuns& runs, const MapMetric& metric) {
    MapLayer layer{
        "place", "Places that may be reached", GeometryKind::line, {}, line_style({0, 0, 160}, 0.9)};
    for (const MapRun& run : runs.runs)
        for (const PlaceRecord& place : run.run.places) {
            const double sign = run.place.descends_with_chainage ? 1.0 : -1.0;
            const double far = place.chainage_m + sign * place.width_m;
            MapFeature feature{place.width_m > 0
                                   ? part_between(run.place.line, std::min(place.chainage_m, far),
                                                  std::max(place.chainage_m, far))
                                   : bar_across(run.place.line, metric, place.chainage_m,
                                                std::sqrt(run.run.measures.source_area_m2)),
                               short_attributes(run)};
            feature.attributes.push_back({"place", place.name});
            feature.attributes.push_back({"kind", place.kind});
            feature.attributes.push_back({"chainage_m", place.chainage_m});
            const bool known = is_result(run.run.status);
            const auto add = [&](const char* name, double value) {
                feature.attributes.push_back(
                    {name, known && std::isfinite(value) ? FieldValue(value) : FieldValue()});
            };
            feature.attributes.push_back(
                {"reached",
                 known ? FieldValue(std::isfinite(place.arrival_time_s) ? 1L : 0L) : FieldValue()});
            feature.attributes.push_back(
                {"within_error",
                 known ? FieldValue(place_doubt(run.run, place).within_error() ? 1L : 0L) : FieldValue()});
            add("arrival_time_s", place.arrival_time_s);
            add("greatest_thickness_m", place.greatest_thickness_m);
            add("greatest_speed_m_s", place.greatest_speed_m_s);
            add("final_thickness_m", place.final_thickness_m);
            layer.features.push_back(std::move(feature));
        }
    return layer;
}

MapLayer failed_layer(const MapRuns& runs) {
    MapLayer layer{"failed_run",
                   "Sections whose run gave no result",
                   GeometryKind::line,
                   {},
                   line_style({0, 0, 0}, 0.9)};
    for (const MapRun& run : runs.runs)
        if (!is_result(run.run.status)) layer.features.push_back({run.place.line.points, run.attributes});
    return layer;
}

MapLayer refused_layer(const std::vector<RefusedSection>& sections, const std::string& crs) {
    MapLayer layer{
        "refused", "Lines that were refused as sections", GeometryKind::line, {}, line_style(red, 0.9)};
    for (const RefusedSection& section : sections) {
        MapFeature feature{drawn_in(section.line, crs), {}};
        for (const Attribute& attribute : section.line.attributes)
            feature.attributes.push_back({"section_" + attribute.name, attribute.value});
        feature.attributes.push_back({"name", section.name});
        feature.attributes.push_back({"feature_id", section.feature_id});
        feature.attributes.push_back({"section_origin", section.origin});
        feature.attributes.push_back({"reason", section.reason});
        layer.features.push_back(std::move(feature));
    }
    return layer;
}

namespace {

void tell_former_fronts(const MapRuns& runs, std::vector<std::string>& remarks) {
    const auto count = std::ranges::count_if(
        runs.runs, [](const MapRun& run) { return run.run.front_definition != current_front_definition; });
    if (count > 0)
        remarks.push_back(fmt::format(
            "{} of {} runs have the former definition of the front (contiguous by top, before database 10)",
            count, runs.runs.size()));
}

}  // namespace

ResultMap result_map(const Store& store, const MapOptions& options) {
    const MapRuns runs = map_runs(store, options.every_run);
    const MapMetric metric(runs.crs, runs.runs.front().place.line.points.front());
    ResultMap map{{runs.crs, {}}, {}};
    tell_former_fronts(runs, map.remarks);
    if (runs.without_place > 0)
        map.remarks.push_back(
            fmt::format("{} runs are not on the map: their sections came from tables that were not placed",
                        runs.without_place));
    MapRuns sources{runs.crs, {}, 0};
    for (const MapRun& run : runs.runs)
        if (is_result(run.run.status)) sources.runs.push_back(run);
    map.sheet.layers = {hazard_band_layer(runs, metric, options.neighbours_within_m),
                        section_layer(runs),
                        deposit_layer(runs),
                        thickness_layer(runs),
                        intensity_layer(runs, options.intensities),
                        source_layer(sources),
                        extent_line_layer(runs, metric),
                        extent_layer(runs)};
    map.sheet.layers.push_back(place_layer(runs, metric));
    for (MapLayer& layer : probability_layers(runs, metric, map.remarks))
        map.sheet.layers.push_back(std::move(layer));
    map.sheet.layers.push_back(failed_layer(runs));
    map.sheet.layers.push_back(refused_layer(store.refused_sections(), runs.crs));
    return map;
}

}  // namespace runout
