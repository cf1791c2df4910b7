#include "report/map/map_runs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "core/input_error.h"
#include "report/text/run_columns.h"

namespace runout {
namespace {

/// Of the line alone: two sections are the same when they lie in the same place and bear the same names.
std::string section_key(const MapLine& line) {
    std::string key;
    for (const Attribute& attribute : line.attributes)
        key += attribute.name + "=" + text_of(attribute.value) + ";";
    for (const Vec2& point : line.points) key += text_of(point.x()) + " " + text_of(point.y()) + ";";
    return key;
}

std::vector<Attribute> attributes_of(const StoredRun& run, const Question& question) {
    std::vector<Attribute> attributes;
    for (const Attribute& attribute : run.section_attributes)
        attributes.push_back({"section_" + attribute.name, attribute.value});
    for (const RunColumn& column : run_columns(run))
        if (column.name != "section_attributes") attributes.push_back({column.name, column.value});
    attributes.push_back({"scenario", question.physical});
    return attributes;
}

bool is_finer(const StoredRun& a, const StoredRun& b) {
    // A result is worth more than a finer run that failed.
    const auto rank = [](const StoredRun& run) {
        return std::tuple(is_result(run.status), -run.work.particle_spacing_m, run.run_id);
    };
    return rank(a) > rank(b);
}

std::vector<MapRun> one_for_each_question(std::vector<MapRun> runs) {
    std::map<std::string, MapRun> best;
    for (MapRun& run : runs) {
        const std::string key = section_key(run.place.line) + run.question.physical + run.question.source;
        const auto [found, fresh] = best.emplace(key, run);
        if (!fresh && is_finer(run.run, found->second.run)) found->second = std::move(run);
    }
    std::vector<MapRun> kept;
    for (auto& [key, run] : best) kept.push_back(std::move(run));
    std::ranges::sort(kept, {}, [](const MapRun& run) { return run.run.run_id; });
    return kept;
}

/// Where a run-out of the former definition ends, which went along the bed.
double chainage_along_bed(const RunPlace& place, double run_out_m) {
    const double sign = place.descends_with_chainage ? 1.0 : -1.0;
    double left = std::max(0.0, run_out_m);
    Vec2 from(0, 0);  // along and above, from the toe
    for (const Vec2& point : place.bed) {
        const Vec2 to(sign * (point.x() - place.toe_chainage_m), point.y() - place.toe_elevation_m);
        if (from.x() < 0 && to.x() > 0)
            from -= from.x() / (to.x() - from.x()) * (to - from);  // below the toe
        if (to.x() <= 0) {
            from = to;
            continue;
        }
        const double length = (to - from).norm();
        if (length >= left && length > 0)
            return place.toe_chainage_m + sign * (from.x() + (to.x() - from.x()) * left / length);
        left -= length;
        from = to;
    }
    return place.toe_chainage_m + sign * from.x();
}

}  // namespace

MapRuns map_runs(const Store& store, bool every_run) {
    MapRuns found;
    for (const StoredRun& run : store.runs()) {
        std::optional<RunPlace> place = store.place(run.run_id);
        if (!place) {
            ++found.without_place;
            continue;
        }
        if (found.crs.empty()) found.crs = place->line.crs;
        place->line = in_system(place->line, found.crs);
        const Question question = store.question(run.run_id);
        found.runs.push_back({run, std::move(*place), question, store.deposit(run.run_id),
                              store.envelope(run.run_id), attributes_of(run, question)});
    }
    if (found.runs.empty())
        throw InputError({"", 0, "map", ""}, "finds no run that lies on a map",
                         "take sections from lines (section.line), or place them with section.origin");
    if (!every_run) found.runs = one_for_each_question(std::move(found.runs));
    return found;
}

double chainage_at_run_out(const RunPlace& place, double run_out_m) {
    const double sign = place.descends_with_chainage ? 1.0 : -1.0;
    const double end = place.bed.empty() ? 0.0 : sign * (place.bed.back().x() - place.toe_chainage_m);
    return place.toe_chainage_m + sign * std::clamp(run_out_m, 0.0, std::max(0.0, end));
}

double run_out_from_toe(const MapRun& run) {
    const double run_out = run.run.measures.run_out_m;
    if (run.run.front_definition == current_front_definition) return run_out;
    const double chainage = chainage_along_bed(run.place, run_out);
    return std::abs(chainage - run.place.toe_chainage_m);
}

double distal_chainage(const MapRun& run) {
    const Measures& measures = run.run.measures;
    if (measures.run_out_m > 0) return chainage_at_run_out(run.place, run_out_from_toe(run));
    const bool with_chainage = run.place.descends_with_chainage;
    double distal = run.place.head.x();
    for (const DepositRow& row : run.deposit)
        if (row.thickness_by_top_m >= measures.front_thickness_m &&
            (with_chainage ? row.chainage_m > distal : row.chainage_m < distal))
            distal = row.chainage_m;
    return distal;
}

LinePlace line_place(const MapLine& line, const MapMetric& metric, double chainage) {
    const auto after = std::ranges::upper_bound(line.chainage_m, chainage);
    const auto i = std::clamp<std::ptrdiff_t>(after - line.chainage_m.begin(), 1,
                                              static_cast<std::ptrdiff_t>(line.points.size()) - 1);
    const auto end = static_cast<std::size_t>(i);
    const Vec2 along = (metric.metres(line.points[end]) - metric.metres(line.points[end - 1])).normalized();
    return {metric.metres(point_at(line, chainage)), {-along.y(), along.x()}};
}

Polyline bar_across(const MapLine& line, const MapMetric& metric, double chainage, double half_length) {
    const auto [at, left] = line_place(line, metric, chainage);
    // The middle is the point on the line itself, not one that went to metres and back.
    return {metric.map(at + half_length * left), point_at(line, chainage),
            metric.map(at - half_length * left)};
}

}  // namespace runout
