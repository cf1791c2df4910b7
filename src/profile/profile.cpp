#include "profile/profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/input_error.h"
#include "core/units.h"

namespace runout {
namespace {

constexpr double nearly_vertical = radians(85.0);
constexpr double flattest_face = radians(15.0);
constexpr double wall_threshold = radians(45.0);

// More is a slip: the earth is smaller. Nearer points would be one after the origin is moved to the toe.
constexpr double farthest_m = 1e8;
constexpr double nearest_m = 1e-7;

constexpr const char* toe_key = "section.toe_chainage_m";
constexpr const char* crest_key = "section.crest_chainage_m";

/// Points in file order, each with the line it stands on.
struct Section {
    std::vector<Vec2> points;
    std::vector<int> lines;
    const std::string& file;

    [[nodiscard]] InputPlace place(std::size_t i, const std::string& key, double value) const {
        return {file, i < lines.size() ? lines[i] : 0, key, fmt::format("{:.12g}", value)};
    }
};

void check_point(const Section& s, std::size_t i) {
    const Vec2& p = s.points[i];
    if (!p.allFinite())
        throw InputError(s.place(i, "chainage_m, elevation_m", std::isfinite(p.x()) ? p.y() : p.x()),
                         "is not a finite number", "give metres, such as 12.5");
    if (std::max(std::abs(p.x()), std::abs(p.y())) > farthest_m)
        throw InputError(s.place(i, "chainage_m, elevation_m", std::abs(p.x()) > farthest_m ? p.x() : p.y()),
                         "is out of range", fmt::format("give metres up to {:g} of either sign", farthest_m));
    if (i == 0) return;
    const Vec2& before = s.points[i - 1];
    if (p.x() < before.x())
        throw InputError(s.place(i, "chainage_m", p.x()),
                         fmt::format("goes back behind {:.12g}, which is an overhang", before.x()),
                         "list the points so that the chainage never decreases");
    if ((p - before).norm() < nearest_m)
        throw InputError(s.place(i, "chainage_m", p.x()), "repeats the point before it",
                         "give each point once; a vertical face is two points with different elevations");
}

/// Keeps the two ends of a vertical face that is given by more points.
Section without_inner_points_of_walls(const Section& s) {
    Section kept{{}, {}, s.file};
    for (std::size_t i = 0; i < s.points.size(); ++i) {
        const std::size_t n = kept.points.size();
        if (n >= 2 && kept.points[n - 1].x() == s.points[i].x() &&
            kept.points[n - 2].x() == s.points[i].x()) {
            const double first = kept.points[n - 1].y() - kept.points[n - 2].y();
            const double next = s.points[i].y() - kept.points[n - 1].y();
            if (first * next < 0)
                throw InputError(s.place(i, "elevation_m", s.points[i].y()),
                                 fmt::format("goes up and down at the chainage {:.12g}", s.points[i].x()),
                                 "a vertical face is two points with one chainage");
            kept.points.pop_back();
            if (!kept.lines.empty()) kept.lines.pop_back();
        }
        kept.points.push_back(s.points[i]);
        if (i < s.lines.size()) kept.lines.push_back(s.lines[i]);
    }
    return kept;
}

/// Chainages as good as equal are one, that of the first: a vertical face, and not a sliver whose two sides
/// become one when the origin is moved to the toe.
void make_walls_vertical(Section& s) {
    for (std::size_t i = 1; i < s.points.size(); ++i)
        if (s.points[i].x() < s.points[i - 1].x() + nearest_m) s.points[i].x() = s.points[i - 1].x();
}

Section checked(const std::vector<Vec2>& points, const std::vector<int>& lines, const std::string& file) {
    Section section{points, lines, file};
    if (points.size() < 2)
        throw InputError({file, 0, "", ""}, points.empty() ? "has no points" : "has one point only",
                         "a section needs at least two points");
    for (std::size_t i = 0; i < points.size(); ++i) check_point(section, i);
    make_walls_vertical(section);
    return without_inner_points_of_walls(section);
}

bool descends_with_chainage(const Section& s, const ProfileOptions& options) {
    // A comparison with NaN is false, so a chainage that is not given does not decide.
    if (options.crest_chainage_m < options.toe_chainage_m) return true;
    if (options.crest_chainage_m > options.toe_chainage_m) return false;
    const double first = s.points.front().y();
    const double last = s.points.back().y();
    if (first != last) return first > last;
    if (std::ranges::all_of(s.points, [&](const Vec2& p) { return p.y() == first; })) return true;
    throw InputError({s.file, 0, "elevation_m", fmt::format("{:.12g}", first)},
                     "stands at both ends, so the section descends neither way",
                     fmt::format("cut it to one hillside, or give {} and {}", crest_key, toe_key));
}

/// Ground from the uphill to the distal end; x is the chainage or its negative.
Polyline turned_downhill(const Section& s, bool with_chainage) {
    Polyline ground = s.points;
    if (with_chainage) return ground;
    std::ranges::reverse(ground);
    for (Vec2& p : ground) p.x() = -p.x();
    return ground;
}

void require_on_section(const Polyline& ground, double x, const char* key, double chainage,
                        const std::string& file) {
    if (x >= ground.front().x() && x <= ground.back().x()) return;
    // The ground may be mirrored; the message speaks in chainages of the file.
    const double sign = x == chainage ? 1.0 : -1.0;
    const auto [low, high] = std::minmax({sign * ground.front().x(), sign * ground.back().x()});
    throw InputError({file, 0, key, fmt::format("{:.12g}", chainage)}, "is not on the section",
                     fmt::format("give a chainage between {:.12g} and {:.12g}", low, high));
}

/// A coordinate of almost nothing is nothing: exact arithmetic on numbers near the smallest double leaves its
/// intervals.
Vec2 without_dust(const Vec2& p) {
    constexpr double dust_m = 1e-12;
    return {std::abs(p.x()) < dust_m ? 0.0 : p.x(), std::abs(p.y()) < dust_m ? 0.0 : p.y()};
}

/// Makes sure the ground has a point at x, and returns where: an old point that is as good as there stays the
/// only one.
double insert_point(Polyline& ground, double x) {
    const auto at = std::ranges::lower_bound(ground, x, {}, [](const Vec2& p) { return p.x(); });
    if (at->x() < x + nearest_m) return at->x();
    const Vec2& a = *(at - 1);
    if (a.x() > x - nearest_m) return a.x();
    const Vec2& b = *at;
    const Vec2 inserted(x, a.y() + (b.y() - a.y()) * ((x - a.x()) / (b.x() - a.x())));
    ground.insert(at, inserted);
    return x;
}

std::size_t first_at(const Polyline& ground, double x) {
    const auto at = std::ranges::lower_bound(ground, x, {}, [](const Vec2& p) { return p.x(); });
    return static_cast<std::size_t>(at - ground.begin());
}

std::size_t last_at(const Polyline& ground, double x) {
    const auto after = std::ranges::upper_bound(ground, x, {}, [](const Vec2& p) { return p.x(); });
    return static_cast<std::size_t>(after - ground.begin()) - 1;
}

/// Inclination of the segment that begins at point i, positive where it descends.
double inclination(const Polyline& ground, std::size_t i) {
    const Vec2 d = ground[i + 1] - ground[i];
    return std::atan2(-d.y(), d.x());
}

double face_threshold(const Polyline& ground) {
    double steepest = 0;
    for (std::size_t i = 0; i + 1 < ground.size(); ++i) {
        const double angle = inclination(ground, i);
        if (angle < nearly_vertical) steepest = std::max(steepest, angle);
    }
    return steepest > 0 ? std::max(flattest_face, steepest / 2) : wall_threshold;
}

std::size_t found_toe(const Polyline& ground, std::size_t crest, double threshold) {
    for (std::size_t i = ground.size() - 1; i > crest; --i)
        if (inclination(ground, i - 1) >= threshold) return i;
    return crest;
}

std::size_t found_crest(const Polyline& ground, std::size_t toe, double threshold) {
    for (std::size_t i = 0; i < toe; ++i)
        if (inclination(ground, i) >= threshold) return i;
    return toe;
}

}  // namespace

Vec2 Profile::to_section(const Vec2& local) const {
    return {toe_chainage_m + (descends_with_chainage ? local.x() : -local.x()), toe_elevation_m + local.y()};
}

Vec2 Profile::to_local(const Vec2& section) const {
    const double along = section.x() - toe_chainage_m;
    return {descends_with_chainage ? along : -along, section.y() - toe_elevation_m};
}

double Profile::slope_angle() const {
    if (crest == toe) return 0;
    const Vec2 rise = ground[crest] - ground[toe];
    return std::atan2(rise.y(), -rise.x());
}

Profile make_profile(const SectionPoints& given, const ProfileOptions& options) {
    const std::string& file = given.origin;
    const Section section = checked(given.points, given.lines, file);
    Profile profile;
    profile.origin = file;
    profile.read_as = given.read_as;
    profile.map_line = given.map_line;
    profile.descends_with_chainage = descends_with_chainage(section, options);

    Polyline ground = turned_downhill(section, profile.descends_with_chainage);
    const double sign = profile.descends_with_chainage ? 1.0 : -1.0;
    double toe_x = sign * options.toe_chainage_m;
    double crest_x = sign * options.crest_chainage_m;
    const bool toe_given = !std::isnan(toe_x);
    const bool crest_given = !std::isnan(crest_x);
    profile.toe_given = toe_given;
    profile.crest_given = crest_given;
    if (toe_given) require_on_section(ground, toe_x, toe_key, options.toe_chainage_m, file);
    if (crest_given) require_on_section(ground, crest_x, crest_key, options.crest_chainage_m, file);
    if (toe_given) toe_x = insert_point(ground, toe_x);
    if (crest_given) crest_x = insert_point(ground, crest_x);

    const double threshold = face_threshold(ground);
    const std::size_t least = crest_given ? first_at(ground, crest_x) : 0;
    profile.toe = toe_given ? last_at(ground, toe_x) : found_toe(ground, least, threshold);
    profile.crest = crest_given ? least : found_crest(ground, profile.toe, threshold);

    const Vec2 toe = ground[profile.toe];
    profile.toe_chainage_m = sign * toe.x() + 0.0;  // + 0.0: a mirrored zero is not to print as -0
    profile.toe_elevation_m = toe.y();
    for (Vec2& p : ground) p = without_dust(p - toe);
    profile.ground = std::move(ground);
    return profile;
}

}  // namespace runout
