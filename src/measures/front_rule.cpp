#include "measures/front_rule.h"

#include <cmath>

namespace runout {

FrontRule front_rule(const Scene& scene) {
    constexpr double usual_window = 0.3, usual_threshold = 0.03;  // over sqrt(S)
    const double across = std::sqrt(scene.source.area);
    return {scene.run.front_window > 0 ? scene.run.front_window : usual_window * across,
            scene.run.front_thickness > 0 ? scene.run.front_thickness : usual_threshold * across};
}

}  // namespace runout
