#pragma once

#include <string>
#include <vector>

#include "gis/map_line.h"

namespace runout {

/// Which features of which vector data set, how near to a section line. Empty: not said.
struct FeatureQuery {
    std::string file{};        ///< of a driver that may read vectors (docs/maps.md)
    std::string layer{};       ///< may be left out where there is one
    std::string where{};       ///< condition on the attributes
    std::string crs{};         ///< replaces what the file says
    std::string name_field{};  ///< must be there if it is given; else "name" is taken where it is there
    std::string kind_field{};  ///< the same with "kind"
    double max_offset_m = 50;  ///< from the section line
};

/// A feature beside a section line, and the chainages between which it lies.
struct NearFeature {
    long feature_id = 0;
    std::string name, kind;  ///< empty where the feature says none
    double from_m = 0, to_m = 0;
};

/// The features within max_offset_m of the line; beyond its ends chainages go on along its straight
/// continuation. Of a polygon, or a line that does not cross the section, the part that is so near is
/// projected onto the section; a line that crosses lies where it crosses. In the order of the layer.
/// Throws InputError that names the key of [places]: a file, layer, field or condition that cannot be used,
/// no coordinate system, a geometry that is none.
std::vector<NearFeature> features_near(const MapLine& line, const FeatureQuery& query);

}  // namespace runout
