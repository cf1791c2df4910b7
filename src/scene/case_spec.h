#pragma once

#include <functional>
#include <limits>
#include <map>
#include <string>
#include <string_view>

#include "core/input_error.h"
#include "gis/near_features.h"
#include "gis/placed_line.h"
#include "profile/profile.h"
#include "profile/section_file.h"
#include "scene/scene.h"
#include "source/source.h"

namespace runout {

/// Where the ground comes from: a file of its own, which may be placed on a map, or a line on a map.
struct SectionSpec {
    std::string file;
    SectionFileOptions format;  ///< of the file
    MapSection map;
    ProfileOptions options;
    LinePlacing placing{};  ///< of a table; its origin is NaN where it lies on no map
};

/// What the user said, key by key, in SI and radians. Each value is within its own range; whether the values
/// go together is found out by make_scene.
struct CaseSpec {
    std::string file;  ///< the case file or bare section, as the user named it
    std::string name;
    SectionSpec section;
    SourceSpec source;
    Material material{.friction_angle = std::numeric_limits<double>::quiet_NaN()};  ///< NaN: not given
    Effects effects;             ///< positions are chainages still
    std::string shaking_record;  ///< file
    Vec2 pseudo_static{0, 0};    ///< force on the soil over its weight, towards the run-out and upwards
    std::vector<Place> places;   ///< x: chainage still, NaN: not given
    FeatureQuery map_places;     ///< [places]: features of a map that are places as well; no file: none
    RunSettings run;
    std::string accuracy = "5%";  ///< of the run-out, for choosing a spacing that is not given

    /// Every key that was given: where, and what stood there. Keys that are absent here have their defaults.
    std::map<std::string, InputPlace, std::less<>> given;

    [[nodiscard]] bool has(std::string_view key) const { return given.find(key) != given.end(); }

    /// Where `key` was given; file and key only when it was not.
    [[nodiscard]] InputPlace place(std::string_view key) const {
        const auto found = given.find(key);
        if (found != given.end()) return found->second;
        return {.file = file, .line = 0, .key = std::string(key), .value = {}};
    }
};

}  // namespace runout
