#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "gis/map_line.h"

namespace runout {

/// A section as its file has it, before toe and crest are looked for: what every reader gives.
struct SectionPoints {
    std::vector<Vec2> points{};         ///< (chainage, elevation) in metres, in file order
    std::vector<int> lines{};           ///< line of the file of each point; empty where a file has no lines
    std::string origin{};               ///< file (and line feature) it came from
    std::string read_as{};              ///< how the file was understood; empty: it left no choice
    std::optional<MapLine> map_line{};  ///< where the section lies; none where the file does not say
};

}  // namespace runout
