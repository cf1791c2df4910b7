#include "report/run_json.h"

#include <nlohmann/json.hpp>
#include <type_traits>

#include "report/run_columns.h"
#include "report/table.h"

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

// A file name need not be UTF-8; JSON must be.
std::string text_of(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string run_json(const StoredRun& run) {
    return text_of(to_json(run));
}

std::string runs_json(const std::vector<StoredRun>& runs) {
    Json array = Json::array();
    for (const StoredRun& run : runs) array.push_back(to_json(run));
    return text_of(array);
}

}  // namespace runout
