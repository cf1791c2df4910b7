#include "gis/map_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>

#include "core/words.h"

namespace runout {
namespace {}  // namespace

Vec2 point_at(const MapLine& line, double chainage) {
    const auto& at = line.chainage_m;
    const auto next = std::ranges::upper_bound(at, chainage);
    if (next == at.begin()) return line.points.front();
    if (next == at.end()) return line.points.back();
    const auto i = static_cast<std::size_t>(next - at.begin());
    const double share = (chainage - at[i - 1]) / (at[i] - at[i - 1]);
    return line.points[i - 1] + share * (line.points[i] - line.points[i - 1]);
}

Polyline part_between(const MapLine& line, double from, double to) {
    if (from > to) std::swap(from, to);
    Polyline part{point_at(line, from)};
    for (std::size_t i = 0; i < line.points.size(); ++i)
        if (line.chainage_m[i] > from && line.chainage_m[i] < to) part.push_back(line.points[i]);
    part.push_back(point_at(line, to));
    return part;
}

std::string text_of(const FieldValue& value) {
    return std::visit(
        [](const auto& held) -> std::string {
            using Held = std::decay_t<decltype(held)>;
            if constexpr (std::is_same_v<Held, std::monostate>)
                return {};
            else
                return fmt::format("{}", held);
        },
        value);
}

std::string attribute_text(const std::vector<Attribute>& attributes, const std::vector<std::string>& names) {
    for (const std::string& name : names)
        for (const Attribute& attribute : attributes) {
            if (lower_case(attribute.name) != name) continue;
            const std::string text = text_of(attribute.value);
            if (!text.empty()) return text;
        }
    return {};
}

}  // namespace runout
