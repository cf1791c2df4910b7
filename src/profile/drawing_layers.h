#pragma once

#include <string>
#include <vector>

#include "gis/drawing.h"

namespace runout {

/// Which layer of a drawing plays which part; empty: none.
struct LayerRoles {
    std::string ground;
    std::string source;
    std::string slip;
};

/// Roles as the option says, completed by what the layers are called. Throws InputError that lists the layers
/// with lines: a layer that has none, no ground to be found, a role that is not known or named twice.
LayerRoles layer_roles(const Drawing& drawing, const std::string& option);

}  // namespace runout
