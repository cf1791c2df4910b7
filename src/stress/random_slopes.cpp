#include "stress/random_slopes.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "core/input_error.h"
#include "stress/stress_point.h"
#include "stress/stress_scene.h"

namespace runout {
namespace {

constexpr int scenes_to_each_hard_one = 3;
constexpr int draws_per_scene = 3;  // a third and more make no valid scene

struct Range {
    std::string_view axis;
    double low, high;
};

/// Where an ordinary cut departs from the ranges of the stress suite.
constexpr Range ordinary[] = {
    {"source_kind", 0, 4},
    {"hillside_shape", 0, 1},
    {"slope_angle_deg", 45, 80},
    {"friction_angle_deg", 28, 42},
    {"base_friction_share", 0.6, 3},
    {"drop_height_ratio", 1, 8},
    {"aspect_ratio", 0.5, 4},
    {"base_angle_share", 0.4, 0.9},
    {"scarp_angle_share", 0.2, 0.95},
    {"run_out_slope_share", -0.3, 0.3},
    {"size_m", 1.5, 8},
    {"gravity_m_s2", 9.81, 9.81},
    {"reversed", 0, 0},
    {"offset_m", 0, 0},
};

std::vector<StressAxis> ordinary_axes() {
    std::vector<StressAxis> axes = stress_axes();
    for (const Range& range : ordinary) {
        const auto axis = std::ranges::find(axes, range.axis, &StressAxis::name);
        axis->low = range.low;
        axis->high = range.high;
    }
    return axes;
}

std::optional<Scene> valid_scene(const StressPoint& point, const std::string& name) {
    try {
        return stress_scene(point, name);
    } catch (const InputError&) {
        return {};
    }
}

}  // namespace

std::vector<Scene> random_slopes(int count, std::uint64_t seed) {
    const int draws = draws_per_scene * count;
    const std::vector<StressPoint> cuts = stress_points(ordinary_axes(), draws, seed);
    const std::vector<StressPoint> hard = stress_points(stress_axes(), draws, seed);
    std::vector<Scene> slopes;
    std::size_t next_cut = 0, next_hard = 0;
    while (static_cast<int>(slopes.size()) < count) {
        const bool is_hard = slopes.size() % scenes_to_each_hard_one == scenes_to_each_hard_one - 1;
        std::size_t& next = is_hard ? next_hard : next_cut;
        const std::vector<StressPoint>& points = is_hard ? hard : cuts;
        if (next == points.size()) break;
        const std::string name = fmt::format("{}-{}-{}", is_hard ? "hard" : "cut", seed, next);
        if (std::optional<Scene> scene = valid_scene(points[next++], name))
            slopes.push_back(std::move(*scene));
    }
    return slopes;
}

}  // namespace runout
