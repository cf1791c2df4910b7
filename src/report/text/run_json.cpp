#include "report/text/run_json.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <span>
#include <type_traits>
#include <utility>

#include "report/text/place_doubt.h"
#include "report/text/run_columns.h"
#include "report/text/table.h"
#include "store/columns.h"

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

template <class Record>
void append_numbers(Json& object, const Record& record, std::span<const RealColumn<Record>> columns) {
    for (const RealColumn<Record>& column : columns) object[column.name] = number(record.*column.value);
}

Json places_json(const StoredRun& run) {
    Json places = Json::array();
    for (const PlaceRecord& place : run.places) {
        Json object = {
            {"name", place.name},
            {"kind", place.kind},
            {"reached", is_result(run.status) ? Json(!std::isnan(place.arrival_time_s)) : Json(nullptr)},
            {"within_error",
             is_result(run.status) ? Json(place_doubt(run, place).within_error()) : Json(nullptr)}};
        append_numbers(object, place, place_columns());
        places.push_back(std::move(object));
    }
    return places;
}

Json barrier_json(const BarrierRecord& barrier) {
    Json object = Json::object();
    append_numbers(object, barrier, barrier_columns());
    return object;
}

/// A run that is looked at by itself also says what its effects did.
Json with_effects(const StoredRun& run) {
    Json object = to_json(run);
    Json effects = Json::object();
    for (const EffectRow& effect : run.effects)
        effects[effect.name] = {{"on", effect.on}, {"why", effect.why}, {"cost_s", number(effect.cost_s)}};
    object["effects"] = effects;
    object["advice"] = run.advice;
    object["places"] = places_json(run);
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
    for (const StoredRun& run : runs) {
        Json object = to_json(run);
        object["places"] = places_json(run);
        array.push_back(std::move(object));
    }
    return text_of(array);
}

}  // namespace runout
