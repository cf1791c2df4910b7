#include "profile/descents.h"

#include <algorithm>
#include <cmath>

namespace runout {
namespace {

constexpr double adjoining = 1.0 / 14;      // of the scale: as far as parts of one descent lie apart
constexpr double narrowest_berm = 0.02;     // of the scale
constexpr double widest_berm_share = 0.6;   // of the height of the lower of the two parts that it joins
constexpr double highest_bund_share = 0.2;  // of the same: how much the ground between may rise
constexpr double widest_hole = 0.1;         // of the relief
constexpr double shallowest_hole = 0.02;    // of the relief: less is noise
constexpr double lesser = 0.5;              // of the highest part
constexpr double farthest_lesser = 0.1;     // of the scale

/// Elevation above a plane that falls with `slope` to the right: what is steeper than the plane falls.
class Tilted {
  public:
    Tilted(const Polyline& ground, double slope) : ground_(ground), slope_(slope) {}

    double operator[](std::size_t i) const {
        return ground_[i].y() + slope_ * (ground_[i].x() - ground_.front().x());
    }
    /// x at which the segment that ends at `i` comes down to `level`.
    [[nodiscard]] double reaches(std::size_t i, double level) const {
        const double above = (*this)[i - 1];
        const double share = (above - level) / (above - (*this)[i]);
        return ground_[i - 1].x() + share * (ground_[i].x() - ground_[i - 1].x());
    }

  private:
    const Polyline& ground_;
    double slope_;
};

/// Where the descent that begins at `crest` ends, and where to look for the next one.
struct Ending {
    std::size_t toe;
    std::size_t next;
};

/// Follows the ground from `crest`, as long as something lower comes within `reach`.
Ending follow(const Polyline& ground, const Tilted& tilted, std::size_t crest, double reach) {
    std::size_t toe = crest;
    std::size_t peak = crest;  // since the toe
    for (std::size_t k = crest + 1; k < ground.size(); ++k) {
        const double here = tilted[k];
        if (here < tilted[toe]) {
            const double at = peak == toe ? ground[toe].x() : tilted.reaches(k, tilted[toe]);
            if (toe > crest && at > ground[toe].x() + reach) return {toe, peak};
            toe = peak = k;
            continue;
        }
        if (here >= tilted[peak]) peak = k;
        if (here >= tilted[crest] || ground[k].x() > ground[toe].x() + reach) return {toe, peak};
    }
    return {toe, ground.size() - 1};
}

/// From one end of the ground to the other; parts within `reach` of each other are one.
std::vector<Descent> single_descents(const Polyline& ground, double slope, double reach) {
    const Tilted tilted(ground, slope);
    std::vector<Descent> found;
    for (std::size_t crest = 0; crest + 1 < ground.size();) {
        const auto [toe, next] = follow(ground, tilted, crest, reach);
        if (toe > crest && ground[crest].y() > ground[toe].y()) found.push_back({crest, toe});
        crest = std::max(next, crest + 1);
    }
    return found;
}

double gap_between(const Polyline& ground, const Descent& upper, const Descent& lower) {
    return ground[lower.crest].x() - ground[upper.toe].x();
}

bool is_berm_between(const Polyline& ground, const Descent& upper, const Descent& lower) {
    const double height = std::min(drop_of(ground, upper), drop_of(ground, lower));
    const double rise = ground[lower.crest].y() - ground[upper.toe].y();
    return gap_between(ground, upper, lower) <= widest_berm_share * height &&
           rise <= highest_bund_share * height;
}

/// Descents that follow each other with nothing but berms between.
using Flight = std::vector<Descent>;

/// Drop of the highest part between two berms, however narrow they are.
double highest_batter(const Polyline& ground, const Flight& flight, double slope, double scale) {
    const Polyline part(ground.begin() + static_cast<long>(flight.front().crest),
                        ground.begin() + static_cast<long>(flight.back().toe) + 1);
    double highest = 0;
    for (const Descent& batter : single_descents(part, slope, narrowest_berm * scale))
        highest = std::max(highest, drop_of(part, batter));
    return highest;
}

/// Small parts at its ends that lie apart become flights of their own.
std::vector<Flight> without_lesser_ends(const Polyline& ground, const Flight& flight, double slope,
                                        double scale) {
    const double highest = highest_batter(ground, flight, slope, scale);
    // Against the height of the rest: what is lesser must not make room for itself.
    const auto apart = [&](const Descent& part, const Descent& rest, double gap) {
        return drop_of(ground, part) < lesser * highest &&
               gap >= farthest_lesser * std::min(scale, drop_of(ground, rest));
    };
    std::size_t first = 0;
    std::size_t last = flight.size() - 1;
    while (first < last && apart(flight[first], {flight[first + 1].crest, flight[last].toe},
                                 gap_between(ground, flight[first], flight[first + 1])))
        ++first;
    while (first < last && apart(flight[last], {flight[first].crest, flight[last - 1].toe},
                                 gap_between(ground, flight[last - 1], flight[last])))
        --last;
    std::vector<Flight> parts;
    for (std::size_t i = 0; i < first; ++i) parts.push_back({flight[i]});
    parts.emplace_back(flight.begin() + static_cast<long>(first),
                       flight.begin() + static_cast<long>(last) + 1);
    for (std::size_t i = last + 1; i < flight.size(); ++i) parts.push_back({flight[i]});
    return parts;
}

std::vector<Flight> flights(const Polyline& ground, double slope, double scale) {
    std::vector<Flight> joined;
    for (const Descent& single : single_descents(ground, slope, adjoining * scale)) {
        if (joined.empty() || !is_berm_between(ground, joined.back().back(), single)) joined.emplace_back();
        joined.back().push_back(single);
    }
    std::vector<Flight> found;
    for (const Flight& flight : joined)
        for (Flight& part : without_lesser_ends(ground, flight, slope, scale))
            found.push_back(std::move(part));
    return found;
}

/// Length of the ground that lies below `level`, m.
double length_below(const Polyline& ground, double level) {
    double length = 0;
    for (std::size_t i = 1; i < ground.size(); ++i) {
        const double run = ground[i].x() - ground[i - 1].x();
        const auto [low, high] = std::minmax(ground[i - 1].y(), ground[i].y());
        if (high < level)
            length += run;
        else if (low < level)
            length += run * (level - low) / (high - low);
    }
    return length;
}

/// Raises the points of holes to their left rim, where the right one is as high or higher.
void fill_from_left(const Polyline& ground, double relief, Polyline& filled) {
    const double wide = widest_hole * relief;
    for (std::size_t rim = 0; rim + 2 < ground.size(); ++rim) {
        const double level = ground[rim].y();
        if (ground[rim + 1].y() >= level || filled[rim + 1].y() >= level) continue;
        double lowest = level;
        std::size_t end = rim + 1;
        for (; end < ground.size() && ground[end].y() < level; ++end) {
            if (ground[end].x() > ground[rim].x() + wide) break;
            lowest = std::min(lowest, ground[end].y());
        }
        if (end == ground.size() || ground[end].y() < level) continue;  // no rim within reach
        const Vec2& a = ground[end - 1];
        const Vec2& b = ground[end];
        const double far_rim = a.x() + (b.x() - a.x()) * ((level - a.y()) / (b.y() - a.y()));
        if (far_rim > ground[rim].x() + wide || level - lowest < shallowest_hole * relief) continue;
        for (std::size_t i = rim + 1; i < end; ++i) filled[i].y() = std::max(filled[i].y(), level);
    }
}

}  // namespace

double drop_of(const Polyline& ground, const Descent& descent) {
    return ground[descent.crest].y() - ground[descent.toe].y();
}

double run_of(const Polyline& ground, const Descent& descent) {
    return ground[descent.toe].x() - ground[descent.crest].x();
}

double relief_of(const Polyline& ground) {
    constexpr double share_of_length = 0.01;
    constexpr int halvings = 40;
    const auto [lowest, highest] =
        std::ranges::minmax(ground, {}, [](const Vec2& point) { return point.y(); });
    const double most = share_of_length * (ground.back().x() - ground.front().x());
    double low = lowest.y();
    double high = std::min(ground.front().y(), ground.back().y());
    if (length_below(ground, high) <= most) return highest.y() - high;
    for (int i = 0; i < halvings; ++i) {
        const double middle = low + 0.5 * (high - low);
        (length_below(ground, middle) > most ? high : low) = middle;
    }
    return highest.y() - high;
}

Polyline without_holes(const Polyline& ground, double relief) {
    Polyline filled = ground;
    fill_from_left(ground, relief, filled);
    Polyline turned(ground.rbegin(), ground.rend());
    Polyline turned_filled(filled.rbegin(), filled.rend());
    for (Vec2& p : turned) p.x() = -p.x();
    fill_from_left(turned, relief, turned_filled);
    for (std::size_t i = 0; i < filled.size(); ++i) filled[i].y() = turned_filled[filled.size() - 1 - i].y();
    return filled;
}

std::vector<Descent> descents(const Polyline& ground, double slope, double scale) {
    std::vector<Descent> found;
    for (const Flight& flight : flights(ground, slope, scale))
        found.push_back({flight.front().crest, flight.back().toe});
    return found;
}

Berm widest_berm(const Polyline& ground, double slope, double scale, const Descent& whole) {
    Berm widest;
    for (const Flight& flight : flights(ground, slope, scale)) {
        if (flight.front().crest < whole.crest || flight.back().toe > whole.toe) continue;
        for (std::size_t i = 1; i < flight.size(); ++i) {
            const double height = std::min(drop_of(ground, flight[i - 1]), drop_of(ground, flight[i]));
            const double share = gap_between(ground, flight[i - 1], flight[i]) / height;
            if (share > widest.share) widest = {share, {flight[i - 1].toe, flight[i].crest}};
        }
    }
    return widest;
}

}  // namespace runout
