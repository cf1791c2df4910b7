#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <set>

#include "report/map/map_styles.h"
#include "report/map/result_map.h"
#include "report/text/reach_probability.h"

namespace runout {
namespace {

constexpr std::array drawn_probabilities = {0.5, 0.1, 0.01};

/// The scenarios of one section: its runs that differ in more than how finely they were computed.
struct Sweep {
    const MapRun* first = nullptr;
    std::vector<ReachSample> samples;
    int failed = 0;
};

std::vector<Sweep> sweeps(const MapRuns& runs) {
    std::map<std::string, Sweep> of_section;
    std::set<std::string> seen;
    for (const MapRun& run : runs.runs) {
        std::string key = run.run.section_origin;
        for (const Vec2& point : run.place.line.points) key += fmt::format(" {} {}", point.x(), point.y());
        if (!seen.insert(key + run.question.physical + run.question.source).second)
            continue;  // another resolution
        Sweep& sweep = of_section[key];
        if (sweep.first == nullptr) sweep.first = &run;
        if (is_result(run.run.status))
            sweep.samples.push_back({run_out_from_toe(run), 1});
        else
            ++sweep.failed;
    }
    std::vector<Sweep> several;
    for (auto& [key, sweep] : of_section)
        if (sweep.samples.size() > 1) several.push_back(std::move(sweep));
    return several;
}

std::vector<Attribute> section_attributes(const Sweep& sweep) {
    std::vector<Attribute> attributes;
    for (const Attribute& attribute : sweep.first->run.section_attributes)
        attributes.push_back({"section_" + attribute.name, attribute.value});
    attributes.push_back({"section_origin", sweep.first->run.section_origin});
    attributes.push_back({"scenarios", static_cast<long>(sweep.samples.size())});
    attributes.push_back({"scenarios_failed", static_cast<long>(sweep.failed)});
    return attributes;
}

void add_stretches(const Sweep& sweep, MapLayer& layer) {
    std::set<double> ends;
    for (const ReachSample& sample : sweep.samples)
        if (sample.run_out_m > 0) ends.insert(sample.run_out_m);
    double from = 0;
    for (const double to : ends) {
        const RunPlace& place = sweep.first->place;
        const Probability probability = probability_of_reaching(sweep.samples, to);
        MapFeature feature{
            part_between(place.line, chainage_at_run_out(place, from), chainage_at_run_out(place, to)),
            section_attributes(sweep)};
        feature.attributes.push_back({"from_run_out_m", from});
        feature.attributes.push_back({"to_run_out_m", to});
        feature.attributes.push_back({"probability", probability.value});
        feature.attributes.push_back({"probability_standard_error", probability.standard_error});
        layer.features.push_back(std::move(feature));
        from = to;
    }
}

std::string name_of(const Sweep& sweep) {
    return sweep.first->run.name;
}

void add_bars(const Sweep& sweep, const MapMetric& metric, MapLayer& layer,
              std::vector<std::string>& remarks) {
    for (const double probability : drawn_probabilities) {
        const ReachDistance reached = distance_reached(sweep.samples, probability);
        if (!std::isfinite(reached.distance_m)) {
            remarks.push_back(fmt::format(
                "{}: {} scenarios are too few for the distance reached with {:g} %; it takes {:.0f}",
                name_of(sweep), sweep.samples.size(), 100 * probability, std::ceil(1 / probability)));
            continue;
        }
        const RunPlace& place = sweep.first->place;
        const double half = std::sqrt(sweep.first->run.measures.source_area_m2);
        MapFeature feature{
            bar_across(place.line, metric, chainage_at_run_out(place, reached.distance_m), half),
            section_attributes(sweep)};
        feature.attributes.push_back({"probability_percent", 100 * probability});
        feature.attributes.push_back({"run_out_m", reached.distance_m});
        feature.attributes.push_back({"run_out_low_m", reached.low_m});
        feature.attributes.push_back({"run_out_high_m", reached.high_m});
        layer.features.push_back(std::move(feature));
    }
}

std::vector<ColourClass> probability_classes() {
    return {{0, 0.01, "up to 1 %", {255, 247, 188}},
            {0.01, 0.1, "1 to 10 %", {254, 196, 79}},
            {0.1, 0.5, "10 to 50 %", {236, 112, 20}},
            {0.5, 1, "more than 50 %", {153, 52, 4}}};
}

std::vector<ColourClass> bar_classes() {
    return {{0, 5, "1 %", {254, 196, 79}}, {5, 30, "10 %", {236, 112, 20}}, {30, 100, "50 %", {153, 52, 4}}};
}

}  // namespace

std::vector<MapLayer> probability_layers(const MapRuns& runs, const MapMetric& metric,
                                         std::vector<std::string>& remarks) {
    MapLayer stretches{"reach_probability",
                       "Share of the scenarios that reach this stretch",
                       GeometryKind::line,
                       {},
                       graduated_line_style("probability", probability_classes(), 1)};
    MapLayer bars{"reach_probability_line",
                  "Distances reached with 50, 10 and 1 %",
                  GeometryKind::line,
                  {},
                  graduated_line_style("probability_percent", bar_classes(), 0.8)};
    for (const Sweep& sweep : sweeps(runs)) {
        add_stretches(sweep, stretches);
        add_bars(sweep, metric, bars, remarks);
        if (sweep.failed > 0)
            remarks.push_back(
                fmt::format("{}: {} of {} scenarios gave no result and are not in its probabilities",
                            name_of(sweep), sweep.failed, sweep.failed + sweep.samples.size()));
    }
    return {stretches, bars};
}

}  // namespace runout
