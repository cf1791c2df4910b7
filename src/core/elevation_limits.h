#pragma once

namespace runout {

// No ground that a slope is cut into lies outside of these; what a file has there stands for "no data"
// (-9999, -32768, 1e20) or counts in another unit.
constexpr double lowest_ground_m = -500;
constexpr double highest_ground_m = 9000;

/// False for NaN as well.
constexpr bool is_elevation(double metres) {
    return metres >= lowest_ground_m && metres <= highest_ground_m;
}

}  // namespace runout
