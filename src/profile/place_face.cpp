#include "profile/place_face.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/input_error.h"
#include "profile/checked_points.h"
#include "profile/face_doubts.h"
#include "profile/foot.h"

namespace runout {
namespace {

constexpr const char* toe_key = "section.toe_chainage_m";
constexpr const char* crest_key = "section.crest_chainage_m";

/// The section seen from one of its ends.
struct Side {
    bool with_chainage = true;
    Polyline ground;
    Descent ends;               ///< toe and crest, given or found
    std::vector<Face> faces{};  ///< as find_faces()
    double scale = 0;           ///< as scale_of() the first of them, m

    [[nodiscard]] double weight() const { return faces.empty() ? 0 : faces.front().weight; }
};

void require_on_section(const std::vector<Vec2>& points, double chainage, const char* key,
                        const std::string& file) {
    if (std::isnan(chainage) || (chainage >= points.front().x() && chainage <= points.back().x())) return;
    throw InputError(
        {file, 0, key, fmt::format("{:.12g}", chainage)}, "is not on the section",
        fmt::format("give a chainage between {:.12g} and {:.12g}", points.front().x(), points.back().x()));
}

/// A chainage that is read off a drawing misses the corner it means: by 5 cm or 0.2 % of the relief, but on a
/// model in the laboratory by no more than 1 % of it.
double reading_tolerance(double relief) {
    return std::clamp(std::max(0.05, 0.002 * relief), nearest_points_m,
                      std::max(0.01 * relief, nearest_points_m));
}

/// The chainage of the nearest point within the tolerance, or else `x`, where the ground now has a point.
double point_near(Polyline& ground, double x, double tolerance) {
    const auto after = std::ranges::lower_bound(ground, x, {}, [](const Vec2& p) { return p.x(); });
    const auto before = after == ground.begin() ? after : after - 1;
    const auto nearest = after == ground.end() || x - before->x() < after->x() - x ? before : after;
    if (std::abs(nearest->x() - x) <= tolerance) return nearest->x();
    const Vec2& a = *before;
    const Vec2& b = *after;
    const Vec2 inserted(x, a.y() + (b.y() - a.y()) * ((x - a.x()) / (b.x() - a.x())));
    ground.insert(after, inserted);
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

/// Ground from the uphill to the distal end.
Polyline seen_from(const std::vector<Vec2>& points, bool with_chainage) {
    Polyline ground = points;
    if (with_chainage) return ground;
    std::ranges::reverse(ground);
    for (Vec2& p : ground) p.x() = -p.x();
    return ground;
}

/// Of the faces between the given ends the one that reaches the given end, or else the heaviest.
void prefer(std::vector<Face>& faces, double relief, const auto& gap_to_given_end) {
    const auto reaches = [&](const Face& face) {
        return gap_to_given_end(face) <= std::max(0.1 * relief, 0.6 * face.height);
    };
    const auto chosen = std::ranges::find_if(faces, reaches);
    if (chosen != faces.end()) std::rotate(faces.begin(), chosen, chosen + 1);
}

/// Toe and crest on one side of the section.
Side searched(const std::vector<Vec2>& points, const ProfileOptions& options, bool with_chainage) {
    Side side{with_chainage, seen_from(points, with_chainage), {}};
    Polyline& ground = side.ground;
    const double sign = with_chainage ? 1.0 : -1.0;
    const bool toe_given = !std::isnan(options.toe_chainage_m);
    const bool crest_given = !std::isnan(options.crest_chainage_m);
    const double tolerance = reading_tolerance(relief_of(ground));
    double toe_x = sign * options.toe_chainage_m;
    double crest_x = sign * options.crest_chainage_m;
    if (toe_given) toe_x = point_near(ground, toe_x, tolerance);
    if (crest_given) crest_x = point_near(ground, crest_x, tolerance);
    const std::size_t first = crest_given ? first_at(ground, crest_x) : 0;
    const std::size_t last = toe_given ? last_at(ground, toe_x) : ground.size() - 1;
    side.ends = {first, toe_given ? last : first};
    if (first >= last || (toe_given && crest_given)) return side;

    const Polyline between(ground.begin() + static_cast<long>(first),
                           ground.begin() + static_cast<long>(last) + 1);
    FaceSearch search = find_faces(between);
    if (toe_given)
        prefer(search.faces, search.relief, [&](const Face& f) { return toe_x - between[f.ends.toe].x(); });
    if (crest_given)
        prefer(search.faces, search.relief,
               [&](const Face& f) { return between[f.ends.crest].x() - crest_x; });
    for (Face& face : search.faces) face.ends = {face.ends.crest + first, face.ends.toe + first};
    side.faces = std::move(search.faces);
    if (side.faces.empty()) {
        if (toe_given) side.ends.crest = last;
        return side;
    }
    side.scale = scale_of(side.faces.front(), search.relief);
    const Descent found = side.faces.front().ends;
    side.ends = {crest_given ? first : found.crest, toe_given ? last : found.toe};
    return side;
}

double inclination_of(const Polyline& ground, const Descent& ends) {
    if (ends.crest == ends.toe) return 0;
    const Vec2 rise = ground[ends.crest] - ground[ends.toe];
    return std::atan2(rise.y(), -rise.x());
}

/// Whether a section descends with the chainage whose ends alone tell.
bool ends_descend(const std::vector<Vec2>& points, const std::string& file) {
    const double first = points.front().y();
    const double last = points.back().y();
    if (first != last) return first > last;
    if (std::ranges::all_of(points, [&](const Vec2& p) { return p.y() == first; })) return true;
    throw InputError({file, 0, "elevation_m", fmt::format("{:.12g}", first)},
                     "stands at both ends, so the section descends neither way",
                     fmt::format("cut it to one hillside, or give {} and {}", crest_key, toe_key));
}

/// The side with the heavier face; `other` is the one that was not taken.
struct Sides {
    Side taken;
    std::optional<Side> other;
};

Sides both_sides(const std::vector<Vec2>& points, const ProfileOptions& options, const std::string& file) {
    // A comparison with NaN is false, so a chainage that is not given does not decide.
    if (options.crest_chainage_m < options.toe_chainage_m) return {searched(points, options, true), {}};
    if (options.crest_chainage_m > options.toe_chainage_m) return {searched(points, options, false), {}};
    Side with = searched(points, options, true);
    Side against = searched(points, options, false);
    const double difference = with.weight() - against.weight();
    const bool alike = std::abs(difference) <= 1e-9 * std::max(with.weight(), against.weight());
    const bool forward = alike ? ends_descend(points, file) : difference > 0;
    if (forward) return {std::move(with), std::move(against)};
    return {std::move(against), std::move(with)};
}

}  // namespace

PlacedFace place_face(const std::vector<Vec2>& points, const ProfileOptions& options,
                      const std::string& file) {
    require_on_section(points, options.toe_chainage_m, toe_key, file);
    require_on_section(points, options.crest_chainage_m, crest_key, file);
    auto [side, other] = both_sides(points, options, file);
    const bool toe_given = !std::isnan(options.toe_chainage_m);
    const bool crest_given = !std::isnan(options.crest_chainage_m);

    PlacedFace placed{side.ground, side.ends, inclination_of(side.ground, side.ends), side.with_chainage, {}};
    if (side.faces.empty()) return placed;
    const GroundSeen seen{side.ground, side.with_chainage, side.scale};
    if (!toe_given && !crest_given) {
        placed.doubts = doubts_about(seen, side.faces);
        if (other && !other->faces.empty())
            add_doubt_of_other_side(placed.doubts, side.faces.front(),
                                    {other->ground, other->with_chainage, other->scale},
                                    other->faces.front());
        const auto [ends, inclination] = placed_ends(placed.ground, side.faces.front(), side.scale);
        placed.ends = ends;
        placed.inclination = inclination;
    } else if (toe_given && !crest_given) {
        placed.doubts = doubts_about_given_toe(seen, side.faces.front(), side.ends.toe);
    }
    return placed;
}

}  // namespace runout
