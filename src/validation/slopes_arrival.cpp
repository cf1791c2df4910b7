#include "validation/slopes_arrival.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace runout::slopes {
namespace {

constexpr double never = std::numeric_limits<double>::quiet_NaN();
constexpr double first_share = 0.001;   // of the soil, that counts as its first
constexpr std::size_t first_least = 3;  // particles: one alone may have been thrown out
constexpr double share_of_way = 0.98;
constexpr double least_zone = 0.01;

double speed_of(const Snapshot& s, std::size_t i) {
    return std::hypot(s.vx_m_s[i], s.vy_m_s[i]);
}

/// Indices by rising value.
std::vector<std::size_t> sorted_by(const std::vector<float>& value) {
    std::vector<std::size_t> order(value.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, {}, [&](std::size_t i) { return value[i]; });
    return order;
}

/// Height below which the first soil lies.
double lowest(const Snapshot& s) {
    const auto share = static_cast<std::size_t>(first_share * static_cast<double>(s.y_m.size()));
    std::vector<float> y = s.y_m;
    const std::size_t place = std::max(first_least, share) - 1;
    if (place >= y.size()) return never;
    std::ranges::nth_element(y, y.begin() + static_cast<long>(place));
    return y[place];
}

/// Mean speed of the soil with `from` <= x < `to`; nothing where that is hardly any.
double zone_speed(const Snapshot& s, double from, double to) {
    double sum = 0;
    double count = 0;
    for (std::size_t i = 0; i < s.x_m.size(); ++i) {
        if (s.x_m[i] < from || s.x_m[i] >= to) continue;
        sum += speed_of(s, i);
        count += 1;
    }
    return count < least_zone * static_cast<double>(s.x_m.size()) ? 0.0 : sum / count;
}

/// Time after which the zone stays slow; linear between snapshots.
double slow_from(const std::vector<Snapshot>& snapshots, double from, double to, double slow) {
    double later_time = never;
    double later_speed = 0;
    for (auto s = snapshots.rbegin(); s != snapshots.rend(); ++s) {
        const double speed = zone_speed(*s, from, to);
        if (speed > slow)
            return s->time_s + (later_time - s->time_s) * (speed - slow) / (speed - later_speed);
        later_time = s->time_s;
        later_speed = speed;
    }
    return never;
}

double front_stops(const std::vector<SeriesRow>& series) {
    if (series.empty()) return never;
    const double stop = share_of_way * series.back().front_mass_995_m;
    const auto there =
        std::ranges::find_if(series, [&](const SeriesRow& r) { return r.front_mass_995_m >= stop; });
    return there == series.end() ? never : there->time_s;
}

double moving_share_behind(const Snapshot& s, double slow) {
    double count = 0;
    for (std::size_t i = 0; i < s.x_m.size(); ++i)
        if (s.x_m[i] < 0.0F && speed_of(s, i) > slow) count += 1;
    return count / static_cast<double>(s.x_m.size());
}

const Snapshot& nearest(const std::vector<Snapshot>& snapshots, double time) {
    return *std::ranges::min_element(snapshots, {},
                                     [&](const Snapshot& s) { return std::abs(s.time_s - time); });
}

double mean_speed(const Snapshot& s, const std::vector<std::size_t>& order, std::size_t first,
                  std::size_t count) {
    double sum = 0;
    for (std::size_t k = first; k < first + count; ++k) sum += speed_of(s, order[k]);
    return sum / static_cast<double>(count);
}

}  // namespace

double first_on_bed(const std::vector<Snapshot>& snapshots, double spacing) {
    double before = never, y_before = never, fall = never;
    for (const Snapshot& s : snapshots) {
        const double y = lowest(s);
        if (y <= spacing)
            return std::isnan(fall) ? never : std::min(s.time_s, before + (y_before - spacing) / fall);
        fall = (y_before - y) / (s.time_s - before);
        before = s.time_s;
        y_before = y;
    }
    return never;
}

double passes_toe(const std::vector<SeriesRow>& series) {
    for (std::size_t k = 1; k < series.size(); ++k) {
        const SeriesRow& a = series[k - 1];
        const SeriesRow& b = series[k];
        if (a.front_mass_995_m < 0.0 && b.front_mass_995_m >= 0.0)
            return a.time_s -
                   (b.time_s - a.time_s) * a.front_mass_995_m / (b.front_mass_995_m - a.front_mass_995_m);
    }
    return never;
}

double rear_speed_share(const std::vector<Snapshot>& snapshots, double time) {
    if (snapshots.empty() || std::isnan(time)) return never;
    const Snapshot& s = nearest(snapshots, time);
    const auto order = sorted_by(s.x_m);
    const std::size_t tenth = order.size() / 10;
    return mean_speed(s, order, 0, tenth) / mean_speed(s, order, order.size() - tenth, tenth);
}

Sequence sequence_of(const std::vector<SeriesRow>& series, const std::vector<Snapshot>& snapshots,
                     double box_length, double slow) {
    constexpr double everywhere = std::numeric_limits<double>::infinity();
    Sequence sequence;
    sequence.front = front_stops(series);
    sequence.toe = slow_from(snapshots, 0.0, box_length, slow);
    sequence.slope = slow_from(snapshots, -everywhere, 0.0, slow);
    sequence.moving_behind =
        snapshots.empty() ? never : moving_share_behind(nearest(snapshots, sequence.front), slow);
    return sequence;
}

}  // namespace runout::slopes
