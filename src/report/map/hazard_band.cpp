#include <algorithm>
#include <map>

#include "report/map/map_styles.h"
#include "report/map/result_map.h"

namespace runout {
namespace {

/// Lines that point more than this apart are no neighbours: cosine of 60 deg.
constexpr double least_cosine = 0.5;

/// A run with the toe of its section and the direction downhill there, in metres on the map.
struct Placed {
    const MapRun* run = nullptr;
    Vec2 toe{0, 0};
    Vec2 downhill{0, 0};
};

Placed placed(const MapRun& run, const MapMetric& metric) {
    const auto [at, left] = line_place(run.place.line, metric, run.place.toe_chainage_m);
    const Vec2 along(left.y(), -left.x());
    return {&run, at, run.place.descends_with_chainage ? along : Vec2(-along)};
}

/// A failed run stands in for its section: no band may pass over it.
bool goes_before(const MapRun& a, const MapRun& b) {
    if (is_result(a.run.status) != is_result(b.run.status)) return is_result(a.run.status);
    return run_out_from_toe(a) > run_out_from_toe(b);
}

/// One run for each section, side by side along the slope.
std::vector<Placed> in_a_row(const std::vector<const MapRun*>& runs, const MapMetric& metric) {
    std::map<std::string, const MapRun*> of_section;
    for (const MapRun* run : runs) {
        const Vec2& first = run->place.line.points.front();
        const Vec2& last = run->place.line.points.back();
        const std::string key =
            text_of(first.x()) + text_of(first.y()) + text_of(last.x()) + text_of(last.y());
        const MapRun*& kept = of_section[key];
        if (kept == nullptr || goes_before(*run, *kept)) kept = run;
    }
    std::vector<Placed> row;
    Vec2 downhill(0, 0);
    for (const auto& [key, run] : of_section) {
        row.push_back(placed(*run, metric));
        downhill += row.back().downhill;
    }
    const Vec2 across(-downhill.y(), downhill.x());
    std::ranges::sort(row, {}, [&](const Placed& item) { return item.toe.dot(across); });
    return row;
}

Polyline from_head_to_margin(const MapRun& run) {
    const double head = run.place.head.x();
    const double margin = distal_chainage(run);
    Polyline side = part_between(run.place.line, head, margin);
    if (head > margin) std::ranges::reverse(side);
    return side;
}

std::vector<Attribute> attributes_of(const MapRun& a, const MapRun& b) {
    const auto label = [](const MapRun& run) { return run.run.name; };
    return {{"name_a", label(a)},
            {"name_b", label(b)},
            {"run_id_a", a.run.run_id},
            {"run_id_b", b.run.run_id},
            {"friction_angle_deg", a.run.friction_angle_deg},
            {"source_type", a.run.source_type},
            {"run_out_a_m", run_out_from_toe(a)},
            {"run_out_b_m", run_out_from_toe(b)},
            {"scenario", a.question.physical}};
}

}  // namespace

MapLayer hazard_band_layer(const MapRuns& runs, const MapMetric& metric, double within_m) {
    MapLayer layer{"hazard_band",
                   "Ground between neighbouring sections that debris may cover",
                   GeometryKind::polygon,
                   {},
                   polygon_style({253, 174, 97, 110}, {215, 48, 39, 200})};
    std::map<std::string, std::vector<const MapRun*>> of_scenario;
    for (const MapRun& run : runs.runs) of_scenario[run.question.physical].push_back(&run);
    for (const auto& [scenario, members] : of_scenario) {
        const std::vector<Placed> row = in_a_row(members, metric);
        for (std::size_t i = 1; i < row.size(); ++i) {
            const Placed& a = row[i - 1];
            const Placed& b = row[i];
            const bool both_moved =
                a.run->run.status == RunStatus::settled && b.run->run.status == RunStatus::settled;
            if (!both_moved || (a.toe - b.toe).norm() > within_m || a.downhill.dot(b.downhill) < least_cosine)
                continue;
            Polyline ring = from_head_to_margin(*a.run);
            const Polyline back = from_head_to_margin(*b.run);
            ring.insert(ring.end(), back.rbegin(), back.rend());
            if (is_valid_ring(ring)) layer.features.push_back({ring, attributes_of(*a.run, *b.run)});
        }
    }
    return layer;
}

}  // namespace runout
