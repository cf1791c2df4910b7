#include "source/area_search.h"

#include <cmath>

namespace runout {
namespace {

/// Relative; a few roundings of an area.
constexpr double tolerance = 1e-14;

/// Where along a stretch the target is bracketed, with area minus target at both ends.
struct Bracket {
    double low, below;
    double high, above;
};

/// The stretch in which the target is passed, by bisection: every area asked for is a Boolean operation.
std::size_t stretch_with_target(const std::vector<Stretch>& way,
                                const std::function<double(const GroundPoint&)>& area_of, double target) {
    std::size_t low = 0;
    std::size_t high = way.size() - 1;  // the end of this stretch is known to reach the target
    while (low < high) {
        const std::size_t middle = low + (high - low) / 2;
        if (area_of({way[middle].segment, way[middle].to}) >= target)
            high = middle;
        else
            low = middle + 1;
    }
    return high;
}

/// Regula falsi with the Illinois halving, and a bisection whenever that stalls. Within one segment the area
/// is a polynomial of second degree, so a dozen evaluations reach the last digit.
double root(Bracket b, const std::function<double(double)>& excess, double small) {
    enum class Side { none, low, high } moved = Side::none;
    for (int i = 0; i < 200; ++i) {
        double next = b.low - b.below * (b.high - b.low) / (b.above - b.below);
        const bool inside = (next - b.low) * (next - b.high) < 0;
        if (!inside || i % 8 == 7) next = b.low + (b.high - b.low) / 2;
        if (next == b.low || next == b.high) break;
        const double value = excess(next);
        if (std::abs(value) <= small) return next;
        // The end that stays a second time counts half, or regula falsi would creep up from one side.
        if (value < 0) {
            if (moved == Side::low) b.above /= 2;
            b.low = next;
            b.below = value;
            moved = Side::low;
        } else {
            if (moved == Side::high) b.below /= 2;
            b.high = next;
            b.above = value;
            moved = Side::high;
        }
    }
    return std::abs(excess(b.low)) < std::abs(excess(b.high)) ? b.low : b.high;
}

}  // namespace

std::optional<GroundPoint> point_with_area(const std::vector<Stretch>& way,
                                           const std::function<double(const GroundPoint&)>& area_of,
                                           double target) {
    if (way.empty()) return std::nullopt;
    const double greatest = area_of({way.back().segment, way.back().to});
    if (greatest == target) return GroundPoint{way.back().segment, way.back().to};
    if (greatest < target) return std::nullopt;

    const Stretch s = way[stretch_with_target(way, area_of, target)];
    const auto excess = [&](double fraction) { return area_of({s.segment, fraction}) - target; };
    const Bracket ends{s.from, excess(s.from), s.to, excess(s.to)};
    if (ends.below >= 0) return GroundPoint{s.segment, s.from};
    return GroundPoint{s.segment, root(ends, excess, tolerance * target)};
}

}  // namespace runout
