#pragma once

#include <vector>

#include "engine/particles/bed_line.h"

namespace runout {

/// A face of the bed, steeper than 2.5 to 1, that a window of thickness does not reach through.
struct BedWall {
    Vec2 foot{0, 0}, top{0, 0};
    bool rises = false;  ///< towards the run-out; else it is a drop

    /// x of the face at an elevation; above and below it that of its top and foot.
    [[nodiscard]] double x_at(double elevation) const;
};

/// Faces of the ground at least `least_height` high, and those of what stands on it (a barrier), by rising x.
std::vector<BedWall> walls_of(const BedLine& ground, const BedLine& bed, double least_height);

}  // namespace runout
