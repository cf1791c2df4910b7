#include "engine/pressure/pressure_filter.h"

#include "engine/pairs/operators.h"

namespace runout {
namespace {

constexpr double fraction = 0.05;  // of the difference to the neighbours in a step

}  // namespace

void PressureFilter::find_gradients(const Neighbours& n, const std::vector<double>& pressure) {
    gradient_.assign(static_cast<std::size_t>(n.soil_count), Vec2{0, 0});
    for (const PairBlock& block : n.blocks) {
        for_each_pair(block, n, [&](int i, int j, int k) {
            gradient_[i] += (pressure[j] - pressure[i]) * Vec2{block.gx[k], block.gy[k]};
        });
    }
    for (int i = 0; i < n.soil_count; ++i) {
        const Vec2 plain = gradient_[i];
        gradient_[i] = {plain.x() * n.correction[0][i] + plain.y() * n.correction[2][i],
                        plain.x() * n.correction[1][i] + plain.y() * n.correction[3][i]};
    }
}

void PressureFilter::apply(const Neighbours& n, const Soil& soil, std::vector<double>& pressure) {
    find_gradients(n, pressure);
    change_.assign(static_cast<std::size_t>(n.soil_count), 0.0);
    for (const PairBlock& block : n.blocks) {
        for_each_pair(block, n, [&](int i, int j, int k) {
            if (j >= n.soil_count) return;
            const Vec2 apart{soil.x[j] - soil.x[i], soil.y[j] - soil.y[i]};
            // The pairs of sleeping soil are not found, so that it has no gradient.
            const Vec2 mean = n.is_asleep(j) ? gradient_[i] : Vec2(0.5 * (gradient_[i] + gradient_[j]));
            change_[i] +=
                static_cast<double>(block.stiffness[k]) * (pressure[j] - pressure[i] - mean.dot(apart));
        });
    }
    for (int i = 0; i < n.soil_count; ++i)
        if (!n.is_asleep(i)) pressure[i] += fraction / lattice_stiffness_ * change_[i];
}

}  // namespace runout
