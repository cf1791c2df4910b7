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

void require_on_section(const std::vector<Vec2>& points, Chainage given, const char* key,
                        const std::string& file) {
    const double first = points.front().x();
    const double last = points.back().x();
    if (!given.is_known() || (given.m >= first && given.m <= last)) return;
    throw InputError({file, 0, key, fmt::format("{:.12g}", given.m)}, "is not on the section",
                     fmt::format("give a chainage between {:.12g} and {:.12g}", first, last));
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

/// What the user says of toe and crest, as places on a ground.
struct Given {
    bool toe = false;
    bool crest = false;
    Descent at;  ///< the ends of the ground where nothing is given
};

Given given_on(Polyline& ground, const ProfileOptions& options, double sign) {
    Given given{options.toe_chainage.is_known(), options.crest_chainage.is_known(), {}};
    const double tolerance = reading_tolerance(relief_of(ground));
    const double toe = given.toe ? point_near(ground, sign * options.toe_chainage.m, tolerance) : 0;
    const double crest = given.crest ? point_near(ground, sign * options.crest_chainage.m, tolerance) : 0;
    given.at.crest = given.crest ? first_at(ground, crest) : 0;
    given.at.toe = given.toe ? last_at(ground, toe) : ground.size() - 1;
    return given;
}

/// Puts the first face first whose given ends lie within `reach(face)` of where they are given; false: none.
bool put_first_what_fits(const Polyline& ground, const Given& given, std::vector<Face>& faces,
                         const auto& reach) {
    const auto fits = [&](const Face& face) {
        const auto near = [&](std::size_t a, std::size_t b) {
            return std::abs(ground[a].x() - ground[b].x()) <= reach(face);
        };
        return (!given.toe || near(face.ends.toe, given.at.toe)) &&
               (!given.crest || near(face.ends.crest, given.at.crest));
    };
    const auto found = std::ranges::find_if(faces, fits);
    if (found == faces.end()) return false;
    std::rotate(faces.begin(), found, found + 1);
    return true;
}

/// Faces of the ground between the given ends, or of the whole ground where one of them has its end there: a
/// given end is then the one that would have been found.
FaceSearch faces_for(const Polyline& ground, const Given& given) {
    FaceSearch whole = find_faces(ground);
    if (!given.toe && !given.crest) return whole;
    const auto close = [&](const Face& face) { return 0.1 * scale_of(face, whole.relief); };
    if (put_first_what_fits(ground, given, whole.faces, close)) return whole;

    const Polyline between(ground.begin() + static_cast<long>(given.at.crest),
                           ground.begin() + static_cast<long>(given.at.toe) + 1);
    FaceSearch part = find_faces(between);
    for (Face& face : part.faces)
        face.ends = {face.ends.crest + given.at.crest, face.ends.toe + given.at.crest};
    put_first_what_fits(ground, given, part.faces, [](const Face& face) { return 0.6 * face.height; });
    return part;
}

/// Toe and crest on one side of the section.
Side searched(const std::vector<Vec2>& points, const ProfileOptions& options, bool with_chainage) {
    Side side{with_chainage, seen_from(points, with_chainage), {}};
    const Given given = given_on(side.ground, options, with_chainage ? 1.0 : -1.0);
    const Descent& at = given.at;
    side.ends = given.toe ? at : Descent{at.crest, at.crest};
    if (at.crest >= at.toe || (given.toe && given.crest)) return side;

    FaceSearch search = faces_for(side.ground, given);
    side.faces = std::move(search.faces);
    if (side.faces.empty()) {
        if (given.toe) side.ends.crest = at.toe;
        return side;
    }
    const Face& found = side.faces.front();
    side.scale = scale_of(found, search.relief);
    side.ends = {given.crest ? at.crest : found.ends.crest, given.toe ? at.toe : found.ends.toe};
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
    // A chainage that is not given is neither before nor behind the other: it does not decide.
    if (options.crest_chainage < options.toe_chainage) return {searched(points, options, true), {}};
    if (options.crest_chainage > options.toe_chainage) return {searched(points, options, false), {}};
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
    require_on_section(points, options.toe_chainage, toe_key, file);
    require_on_section(points, options.crest_chainage, crest_key, file);
    auto [side, other] = both_sides(points, options, file);
    const bool toe_given = options.toe_chainage.is_known();
    const bool crest_given = options.crest_chainage.is_known();

    PlacedFace placed{side.ground, side.ends, inclination_of(side.ground, side.ends), side.with_chainage, {}};
    if (side.faces.empty()) return placed;
    const GroundSeen seen{side.ground, side.with_chainage, side.scale};
    if (!toe_given && !crest_given) {
        placed.doubts = doubts_about(seen, side.faces);
        if (other && !other->faces.empty())
            add_doubt_of_other_side(placed.doubts, side.faces.front(),
                                    {other->ground, other->with_chainage, other->scale},
                                    other->faces.front());
    } else if (toe_given && !crest_given) {
        placed.doubts = doubts_about_given_toe(seen, side.faces.front(), side.ends.toe);
    }
    Face face = side.faces.front();
    face.ends = side.ends;
    const auto [ends, inclination] = placed_ends(placed.ground, face, side.scale, {toe_given, crest_given});
    placed.ends = ends;
    placed.inclination = inclination;
    return placed;
}

}  // namespace runout
