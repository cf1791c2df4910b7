#include "engine/effects/side_walls.h"

#include <algorithm>
#include <cmath>

namespace runout {

double brake_by_side_walls(const SideWalls& walls, const Discretisation& discretisation,
                           const std::vector<double>* pore_pressure, double dt, Soil& soil) {
    const double scale = 2.0 * std::tan(walls.angle) * dt / (discretisation.density * walls.width);
    double taken = 0.0;
    for (int i = 0; i < soil.count; ++i) {
        const double water = pore_pressure != nullptr ? (*pore_pressure)[i] : 0.0;
        const double loss = scale * std::max(0.0, soil.pressure[i] - water);
        const double speed = std::sqrt(soil.vx[i] * soil.vx[i] + soil.vy[i] * soil.vy[i]);
        if (loss <= 0.0 || speed <= 0.0) continue;
        const double kept = std::max(0.0, 1.0 - loss / speed);
        soil.vx[i] *= kept;
        soil.vy[i] *= kept;
        taken += 0.5 * speed * speed * (1.0 - kept * kept);
    }
    return taken;
}

}  // namespace runout
