#pragma once

#include <numbers>

namespace runout {

// Files and reports speak degrees; everything inside is radians. These two are the border.
constexpr double radians(double degrees) {
    return degrees * std::numbers::pi / 180.0;
}
constexpr double degrees(double radians) {
    return radians * 180.0 / std::numbers::pi;
}

}  // namespace runout
