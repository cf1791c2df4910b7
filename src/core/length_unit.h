#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace runout {

/// A unit of length that tables and drawings come in.
struct LengthUnit {
    std::string_view name;  ///< "metres", "feet (0.3048 m)"
    double metres = 1;

    [[nodiscard]] constexpr bool is_foot() const { return metres > 0.3 && metres < 0.31; }
};

/// By the word that section.unit has for it. Nothing for another word.
constexpr std::optional<LengthUnit> length_unit(std::string_view word) {
    constexpr std::array<std::pair<std::string_view, LengthUnit>, 6> units = {
        {{"m", {"metres", 1}},
         {"cm", {"centimetres", 0.01}},
         {"mm", {"millimetres", 0.001}},
         {"ft", {"feet (0.3048 m)", 0.3048}},
         {"us-ft", {"US survey feet (1200/3937 m)", 1200.0 / 3937.0}},
         {"in", {"inches", 0.0254}}}};
    for (const auto& [known, unit] : units)
        if (known == word) return unit;
    return std::nullopt;
}

/// Throws InputError that names section.unit for another word.
LengthUnit known_length_unit(std::string_view word);

}  // namespace runout
