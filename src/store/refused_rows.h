#pragma once

#include <string>
#include <vector>

#include "gis/map_line.h"

namespace SQLite {
class Database;
}

namespace runout {

/// A section that was asked for and refused as input.
struct RefusedSection {
    std::string origin;  ///< file and layer
    long feature_id = 0;
    std::string name;
    std::string reason;  ///< one sentence
    MapLine line;        ///< with its attributes; no points where nothing of it can be drawn
};

/// What became of the sections of a layer that were asked for together.
struct SectionsTaken {
    std::string origin;
    std::vector<long> taken;  ///< feature ids
    std::vector<RefusedSection> refused;
};

/// The refused replace what was said of them before; those that were taken are struck off.
void set_sections(SQLite::Database& database, const SectionsTaken& sections);

/// By origin and feature.
std::vector<RefusedSection> select_refused_sections(SQLite::Database& database);

}  // namespace runout
