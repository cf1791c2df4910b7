#pragma once

#include <string>

#include "scene/scene.h"

namespace runout {

/// Hashes (SHA-256, hex) by which equal things share one row of the database. Each includes the one before
/// it.
struct SceneIdentity {
    std::string section;   ///< points and frame of the ground
    std::string source;    ///< and the mass that moves
    std::string scenario;  ///< and all else that determines the result
};
SceneIdentity scene_identity(const Scene& scene);

/// SHA-256 (hex) of a line on a map with its attributes.
std::string map_line_hash(const MapLine& line);

/// "projected", "explicit".
std::string friction_scheme_name(FrictionScheme scheme);

}  // namespace runout
