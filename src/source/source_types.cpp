#include "source/source_types.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "source/shapes.h"

namespace runout {
namespace {

using S = SourceSpec;

constexpr std::array<SpecKey, 5> box_keys = {&S::area, &S::length, &S::thickness, &S::aspect,
                                             &S::drop_height};
constexpr std::array<SpecKey, 6> dipping_box_keys = {&S::base_angle, &S::area,   &S::length,
                                                     &S::thickness,  &S::aspect, &S::drop_height};
constexpr std::array<SpecKey, 5> wedge_keys = {&S::base_angle, &S::scarp_angle, &S::area, &S::height,
                                               &S::drop_height};

constexpr auto table = std::to_array<SourceTypeRow>({
    {SourceType::rectangle, "rectangle", Placement::by_drop_height, box_keys, 0, derive_rectangle},
    {SourceType::a, "A", Placement::by_drop_height, dipping_box_keys, 0, derive_a},
    {SourceType::b, "B", Placement::by_drop_height, wedge_keys, 0, derive_b},
    {SourceType::c, "C", Placement::below_crest, wedge_keys, 0, derive_c},
    {SourceType::polygon, "polygon", Placement::by_outline, {}, 3, derive_polygon},
    {SourceType::slip_surface, "slip_surface", Placement::by_slip_surface, {}, 2, derive_slip_surface},
});

[[noreturn]] void refuse_type(const std::string& value) {
    std::string known;
    for (const SourceTypeRow& row : table) known += fmt::format("{}{}", known.empty() ? "" : ", ", row.name);
    throw InputError({.file = {}, .line = 0, .key = "source.type", .value = value}, "is not a known type",
                     "known are " + known);
}

}  // namespace

std::span<const SourceTypeRow> source_types() {
    return table;
}

const SourceTypeRow& row_of(SourceType type) {
    const auto* const row = std::ranges::find(table, type, &SourceTypeRow::type);
    if (row == table.end()) refuse_type(fmt::format("{}", static_cast<int>(type)));
    return *row;
}

SourceType source_type_named(std::string_view name) {
    const auto* const row = std::ranges::find(table, name, &SourceTypeRow::name);
    if (row == table.end()) refuse_type(std::string(name));
    return row->type;
}

bool uses(SourceType type, SpecKey key) {
    return std::ranges::find(row_of(type).keys, key) != row_of(type).keys.end();
}

bool takes_points(SourceType type) {
    return row_of(type).fewest_points > 0;
}

double height_of(const Profile& profile, const Source& source) {
    const bool behind_crest = row_of(source.type).placement == Placement::below_crest;
    const double top = behind_crest ? profile.ground[profile.crest].y() : source.head.y();
    return top - source.exit_point.y();
}

std::string to_string(SourceType type) {
    return std::string(row_of(type).name);
}

}  // namespace runout
