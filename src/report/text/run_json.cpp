#include "report/text/run_json.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "report/text/run_columns.h"
#include "report/text/table.h"

namespace runout {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Cell& cell) {
    return std::visit(
        [](const auto& value) -> Json {
            if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::monostate>)
                return nullptr;
            else
                return value;
        },
        cell);
}

Json to_json(const StoredRun& run) {
    Json object = Json::object();
    for (const RunColumn& column : run_columns(run)) object[column.name] = to_json(column.value);
    // A text in the other formats, which have no objects.
    if (!run.section_attributes.empty())
        object["section_attributes"] = Json::parse(object["section_attributes"].get<std::string>());
    return object;
}

Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json gauges_json(const StoredRun& run) {
    Json gauges = Json::array();
    for (const GaugeRecord& gauge : run.gauges)
        gauges.push_back({{"name", gauge.name},
                          {"chainage_m", number(gauge.chainage_m)},
                          {"arrival_time_s", number(gauge.arrival_time_s)},
                          {"greatest_thickness_m", number(gauge.greatest_thickness_m)},
                          {"greatest_speed_m_s", number(gauge.greatest_speed_m_s)},
                          {"greatest_kinetic_head_m", number(gauge.greatest_kinetic_head_m)},
                          {"passed_area_m2", number(gauge.passed_area_m2)}});
    return gauges;
}

Json barrier_json(const BarrierRecord& barrier) {
    return {{"arrival_time_s", number(barrier.arrival_time_s)},
            {"greatest_force_n_m", number(barrier.greatest_force_n_m)},
            {"greatest_force_time_s", number(barrier.greatest_force_time_s)},
            {"greatest_moment_n", number(barrier.greatest_moment_n)},
            {"impulse_n_s_m", number(barrier.impulse_n_s_m)},
            {"last_force_n_m", number(barrier.last_force_n_m)},
            {"run_up_m", number(barrier.run_up_m)},
            {"overtopped_area_m2", number(barrier.overtopped_area_m2)},
            {"approach_speed_m_s", number(barrier.approach_speed_m_s)},
            {"approach_thickness_m", number(barrier.approach_thickness_m)},
            {"design_force_n_m", number(barrier.design_force_n_m)}};
}

/// A run that is looked at by itself also says what its effects did.
Json with_effects(const StoredRun& run) {
    Json object = to_json(run);
    Json effects = Json::object();
    for (const EffectRow& effect : run.effects)
        effects[effect.name] = {{"on", effect.on}, {"why", effect.why}, {"cost_s", number(effect.cost_s)}};
    object["effects"] = effects;
    object["advice"] = run.advice;
    object["gauges"] = gauges_json(run);
    object["barrier"] = run.barriers.empty() ? Json(nullptr) : barrier_json(run.barriers.front());
    return object;
}

// A file name need not be UTF-8; JSON must be.
std::string text_of(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string run_json(const StoredRun& run) {
    return text_of(with_effects(run));
}

std::string runs_json(const std::vector<StoredRun>& runs) {
    Json array = Json::array();
    for (const StoredRun& run : runs) array.push_back(to_json(run));
    return text_of(array);
}

}  // namespace runout
