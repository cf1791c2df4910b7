#include "validation/discontinuity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace runout {
namespace {

constexpr double least_share = 0.05;  // of the soil on either side, for a split that means something
constexpr std::size_t least_in_strip = 12;

using Sample = std::pair<double, double>;  // distance from the plane towards the front, speed

/// Running sums of a set of speeds.
struct Tally {
    double count = 0, sum = 0;

    void add(double speed) {
        count += 1;
        sum += speed;
    }
    [[nodiscard]] double mean() const { return sum / count; }
};

/// Sum of squares between two sets and their common mean.
double between(const Tally& a, const Tally& b) {
    const double difference = a.mean() - b.mean();
    return a.count * b.count / (a.count + b.count) * difference * difference;
}

Vec2 uphill(double angle) {
    return {-std::cos(angle), std::sin(angle)};
}

Vec2 to_front(double angle) {
    return {std::sin(angle), std::cos(angle)};
}

double speed_of(const Snapshot& s, std::size_t i) {
    return std::hypot(s.vx_m_s[i], s.vy_m_s[i]);
}

Vec2 place_of(const Snapshot& s, std::size_t i) {
    return {s.x_m[i], s.y_m[i]};
}

double total_square(const Snapshot& s) {
    Tally all;
    double squares = 0;
    for (std::size_t i = 0; i < s.x_m.size(); ++i) {
        all.add(speed_of(s, i));
        squares += speed_of(s, i) * speed_of(s, i);
    }
    return squares - all.sum * all.mean();
}

Discontinuity split_at(const Snapshot& s, const Vec2& exit, double angle) {
    Tally front, rear;
    const Vec2 normal = to_front(angle);
    for (std::size_t i = 0; i < s.x_m.size(); ++i)
        ((place_of(s, i) - exit).dot(normal) > 0.0 ? front : rear).add(speed_of(s, i));
    const double all = front.count + rear.count;
    if (std::min(front.count, rear.count) < std::max(1.0, least_share * all)) return {};
    return {angle, between(front, rear), front.mean(), rear.mean(), front.count / all};
}

/// Distance at which soil sorted by distance splits best.
double best_split(std::vector<Sample>& soil) {
    std::ranges::sort(soil);
    Tally rear, front;
    for (const Sample& sample : soil) front.add(sample.second);
    double best = -1.0;
    double place = 0.0;
    const auto fewest = std::max<std::size_t>(2, soil.size() / 20);
    for (std::size_t k = 0; k + fewest < soil.size(); ++k) {
        rear.add(soil[k].second);
        front.count -= 1;
        front.sum -= soil[k].second;
        if (k + 1 < fewest || between(front, rear) <= best) continue;
        best = between(front, rear);
        place = 0.5 * (soil[k].first + soil[k + 1].first);
    }
    return place;
}

}  // namespace

Discontinuity find_discontinuity(const Snapshot& snapshot, const Vec2& exit, const PlaneSearch& search) {
    Discontinuity best;
    for (double angle = search.lowest; angle <= search.highest; angle += search.step) {
        const Discontinuity tried = split_at(snapshot, exit, angle);
        // A plane above which the soil is the slower is none: it would cut off the rear.
        if (tried.front_speed > tried.rear_speed && tried.contrast > best.contrast) best = tried;
    }
    if (best.contrast <= 0.0) {
        best.angle = std::numeric_limits<double>::quiet_NaN();
        return best;
    }
    best.contrast /= total_square(snapshot);
    return best;
}

double discontinuity_angle(const Snapshot& snapshot, const Vec2& exit, const PlaneSearch& search) {
    return find_discontinuity(snapshot, exit, search).angle;
}

Polyline discontinuity_trace(const Snapshot& snapshot, const Vec2& exit, int strips,
                             const PlaneSearch& search) {
    const double angle = discontinuity_angle(snapshot, exit, search);
    if (std::isnan(angle)) return {};
    const Vec2 along = uphill(angle);
    const Vec2 normal = to_front(angle);
    double length = 0.0;
    for (std::size_t i = 0; i < snapshot.x_m.size(); ++i)
        length = std::max(length, (place_of(snapshot, i) - exit).dot(along));
    std::vector<std::vector<Sample>> soil(static_cast<std::size_t>(strips));
    for (std::size_t i = 0; i < snapshot.x_m.size(); ++i) {
        const Vec2 from_exit = place_of(snapshot, i) - exit;
        const double strip = std::floor(from_exit.dot(along) / length * strips);
        if (strip < 0.0) continue;  // already below P
        soil[std::min(static_cast<std::size_t>(strip), soil.size() - 1)].emplace_back(from_exit.dot(normal),
                                                                                      speed_of(snapshot, i));
    }
    Polyline trace;
    for (std::size_t k = 0; k < soil.size(); ++k) {
        if (soil[k].size() < least_in_strip) continue;
        const double middle = (static_cast<double>(k) + 0.5) * length / strips;
        trace.emplace_back(exit + middle * along + best_split(soil[k]) * normal);
    }
    return trace;
}

}  // namespace runout
