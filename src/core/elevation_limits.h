#pragma once

namespace runout {

// No ground that a slope is cut into lies outside of these; what a file has there stands for "no data"
// (-9999, -32768, 1e20) or counts in another unit.
constexpr double lowest_elevation_m = -500;
constexpr double highest_elevation_m = 9000;

/// False for NaN as well.
constexpr bool is_elevation(double metres) {
    return metres >= lowest_elevation_m && metres <= highest_elevation_m;
}

}  // namespace runout
