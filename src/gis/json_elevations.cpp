#include "gis/json_elevations.h"

#include <cpl_json.h>

namespace runout {
namespace {

bool is_number(const CPLJSONObject& value) {
    const auto type = value.GetType();
    return type == CPLJSONObject::Type::Integer || type == CPLJSONObject::Type::Long ||
           type == CPLJSONObject::Type::Double;
}

}  // namespace

std::vector<bool> has_third_number(const std::string& feature) {
    CPLJSONDocument document;
    if (feature.empty() || !document.LoadMemory(feature)) return {};
    const CPLJSONObject geometry = document.GetRoot().GetObj("geometry");
    CPLJSONArray positions = geometry.GetArray("coordinates");
    if (geometry.GetString("type") == "MultiLineString" && positions.Size() == 1)
        positions = positions[0].ToArray();
    else if (geometry.GetString("type") != "LineString")
        return {};
    std::vector<bool> found;
    for (int i = 0; i < positions.Size(); ++i) {
        const CPLJSONArray position = positions[i].ToArray();
        found.push_back(position.Size() > 2 && is_number(position[2]));
    }
    return found;
}

}  // namespace runout
