#pragma once

#include "scene/scene.h"

namespace runout {

/// What counts as the front: soil that is `threshold` thick in a window of half-width `window`, m. Both are
/// lengths of the scene and do not change with the spacing (docs/front.md).
struct FrontRule {
    double window = 0;
    double threshold = 0;
};

/// As the case gives it; else 0.3 and 0.03 times the square root of the source's area.
FrontRule front_rule(const Scene& scene);

}  // namespace runout
