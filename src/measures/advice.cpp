#include "measures/advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/units.h"
#include "measures/deposit.h"

namespace runout {
namespace {

constexpr double front_share = 0.2;       // of the mass that counts as the front
constexpr double quasi_static = 0.1;      // inertial number above which friction rises by more than a tenth
constexpr double worth_saying = 0.2;      // share of the front
constexpr double grain_diameter = 0.002;  // m, coarse sand to fine gravel; the number is proportional to it
constexpr double grain_density = 2650;    // kg/m3
constexpr double moist_cohesion = 5e3;    // Pa, what suction may give moist sand

/// Vertical extent, m.
double height_of(const Polygon& outline) {
    const auto [low, high] = std::minmax_element(outline.begin(), outline.end(),
                                                 [](const Vec2& a, const Vec2& b) { return a.y() < b.y(); });
    return high->y() - low->y();
}

/// Cohesion at which a vertical face stands as high as the source: H = (4 c/(rho g)) tan(45 + phi/2), Pa.
double holding_cohesion(const Scene& scene) {
    const double bearing = 4.0 * std::tan(radians(45.0) + 0.5 * scene.material.friction_angle);
    return scene.material.density * scene.run.gravity * height_of(scene.source.outline) / bearing;
}

}  // namespace

Advisor::Advisor(const Scene& scene, double interval)
    : rate_(scene.effects.rate.has_value()),
      source_height_(height_of(scene.source.outline)),
      holding_cohesion_(scene.effects.cohesion ? std::numeric_limits<double>::infinity()
                                               : holding_cohesion(scene)),
      density_(scene.material.density),
      interval_(interval) {}

void Advisor::look(const Simulation& simulation) {
    if (!simulation.released() || simulation.time() < due_) return;
    due_ = simulation.time() + interval_;
    if (!rate_) look_at_rate(simulation);
}

/// Share of the front with I = 2 |e| d sqrt(rho_s / p) above the quasi-static range. Only soil under pressure
/// counts: where p is next to nothing I has no meaning.
void Advisor::look_at_rate(const Simulation& simulation) {
    const StateView state = simulation.state();
    const std::vector<double> rate = simulation.strain_rate();
    const double start = mass_front(state, front_share);
    const double least_pressure = 0.25 * density_ * state.gravity * state.discretisation->spacing;
    std::vector<double> numbers;
    for (std::size_t i = 0; i < state.x.size(); ++i) {
        if (state.x[i] < start || state.pressure[i] < least_pressure) continue;
        numbers.push_back(2.0 * rate[i] * grain_diameter * std::sqrt(grain_density / state.pressure[i]));
    }
    if (numbers.size() < 10) return;
    const auto fast =
        std::count_if(numbers.begin(), numbers.end(), [](double n) { return n > quasi_static; });
    const double share = static_cast<double>(fast) / static_cast<double>(numbers.size());
    if (share <= fast_share_) return;
    const auto high = numbers.begin() + static_cast<long>(0.9 * static_cast<double>(numbers.size()));
    std::nth_element(numbers.begin(), high, numbers.end());
    fast_share_ = share;
    fast_number_ = *high;
    fast_time_ = state.time;
}

std::vector<std::string> Advisor::sentences() const {
    std::vector<std::string> said;
    if (fast_share_ > worth_saying)
        said.push_back(fmt::format(
            "The inertial number exceeded {} over {:.0f} % of the front at t = {:.3g} s (a tenth of it "
            "was above {:.2g}; grains of {:.0f} mm, proportional to their size): "
            "[effects.rate] may matter.",
            quasi_static, 100 * fast_share_, fast_time_, fast_number_, 1e3 * grain_diameter));
    if (holding_cohesion_ < moist_cohesion)
        said.push_back(
            fmt::format("A cohesion of {:.2g} kPa would hold a vertical face as high as the source ({:.2g} "
                        "m), and moist sand may have it: [effects.cohesion] may matter.",
                        1e-3 * holding_cohesion_, source_height_));
    return said;
}

}  // namespace runout
