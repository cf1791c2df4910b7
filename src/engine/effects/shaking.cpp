#include "engine/effects/shaking.h"

#include <algorithm>

namespace runout {

Vec2 GroundMotion::acceleration(double time) const {
    const auto& [times, horizontal, vertical] = shaking_;
    if (times.empty()) return {horizontal.front(), vertical.front()};
    if (time >= times.back()) return {0.0, 0.0};
    const auto next =
        static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), time) - times.begin());
    const double fraction = (time - times[next - 1]) / (times[next] - times[next - 1]);
    const auto between = [&](const std::vector<double>& values) {
        return values[next - 1] + fraction * (values[next] - values[next - 1]);
    };
    return {between(horizontal), between(vertical)};
}

}  // namespace runout
