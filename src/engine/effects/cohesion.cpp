#include "engine/effects/cohesion.h"

#include <algorithm>
#include <cmath>

#include "core/vec2.h"

namespace runout {
namespace {

constexpr double shifting = 0.1;        // of the way to even spacing in a step
constexpr double most_shifting = 0.02;  // spacings a step
constexpr double shifting_way = 0.8;    // of the way that the particle has moved in the step

}  // namespace

void shift_crowded(ParticleSystem& particles, const Discretisation& discretisation, double gravity, double dt,
                   WorkLedger& ledger) {
    const Neighbours& n = particles.neighbours;
    Soil& soil = particles.soil;
    const double scale = shifting * discretisation.volume();
    const double most = most_shifting * discretisation.spacing;
    for (int i = 0; i < soil.count; ++i) {
        if (n.density[i] < surface_density || n.is_asleep(i)) continue;
        Vec2 shift{-scale * n.surface_x[i], -scale * n.surface_y[i]};
        const double size = shift.norm();
        const double longest = std::min(most, shifting_way * dt * std::hypot(soil.vx[i], soil.vy[i]));
        if (size > longest) shift *= longest / size;
        soil.x[i] += shift.x();
        soil.y[i] += shift.y();
        ledger.numerical -= discretisation.mass() * gravity * shift.y();
    }
}

}  // namespace runout
