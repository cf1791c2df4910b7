#include "profile/face_doubts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/units.h"

namespace runout {
namespace {

constexpr double worth_naming = 1.0 / 3;  // of the height of the chosen face
constexpr double other_side = 0.25;       // of its weight
constexpr double nested_counts = 0.8;     // of its weight, for one that holds it or is a part of it
constexpr double apart = 0.1;             // of the scale: toes and crests nearer than this are one
constexpr double worth_doubting = 0.5;    // length of a berm over the height of the lower part beside it
constexpr double given_apart = 0.25;      // of the scale
constexpr std::size_t most_named = 3;

// Which part of the inclination of the face still counts as its part, beside one half.
constexpr std::array<double, 2> other_shares = {0.35, 0.7};

double chainage(const GroundSeen& seen, std::size_t i) {
    return seen.with_chainage ? seen.ground[i].x() : -seen.ground[i].x() + 0.0;
}

/// "from chainage 30 down to 41.547, 20 m high at 60 deg"
std::string described(const GroundSeen& seen, const Face& face) {
    const double mean = std::atan2(face.height, run_of(seen.ground, face.ends));
    return fmt::format("from chainage {:.6g} down to {:.6g}, {:.3g} m high at {:.0f} deg",
                       chainage(seen, face.ends.crest), chainage(seen, face.ends.toe), face.height,
                       degrees(mean));
}

/// "... (section.toe_chainage_m = 41.547)"
std::string described_with_key(const GroundSeen& seen, const Face& face) {
    return fmt::format("{} (section.toe_chainage_m = {:.6g}, section.crest_chainage_m = {:.6g})",
                       described(seen, face), chainage(seen, face.ends.toe), chainage(seen, face.ends.crest));
}

bool could_be_meant(const GroundSeen& seen, const Face& chosen, const Face& other) {
    const auto far = [&](std::size_t a, std::size_t b) {
        return std::abs(seen.ground[a].x() - seen.ground[b].x()) > apart * seen.scale;
    };
    if (other.inclination == std::numbers::pi / 2 && chosen.ends.crest <= other.ends.crest &&
        other.ends.toe <= chosen.ends.toe)
        return false;  // a wall in the cut
    if (!far(chosen.ends.toe, other.ends.toe) && !far(chosen.ends.crest, other.ends.crest)) return false;
    const bool overlap = other.ends.crest < chosen.ends.toe && chosen.ends.crest < other.ends.toe;
    return overlap ? other.weight >= nested_counts * chosen.weight
                   : other.height >= worth_naming * chosen.height;
}

void add_doubt_of_others(std::vector<std::string>& doubts, const GroundSeen& seen,
                         const std::vector<Face>& faces) {
    std::vector<std::string> named;
    for (std::size_t i = 1; i < faces.size() && named.size() < most_named; ++i)
        if (could_be_meant(seen, faces.front(), faces[i]))
            named.push_back(described_with_key(seen, faces[i]));
    if (named.empty()) return;
    doubts.push_back(fmt::format(
        "The cut was taken to be the descent {}, but it could also be the one {}; name it if it is.",
        described(seen, faces.front()), fmt::join(named, ", or the one ")));
}

void add_doubt_of_berm(std::vector<std::string>& doubts, const GroundSeen& seen, const Face& face) {
    const Berm berm = widest_berm(without_holes(seen.ground, seen.scale), std::tan(face.inclination / 2),
                                  seen.scale, face.ends);
    if (berm.share <= worth_doubting) return;
    doubts.push_back(
        fmt::format("The level stretch from chainage {:.6g} to {:.6g} was taken to be a berm of the cut; if "
                    "it is a road or the "
                    "ground below the cut, give section.toe_chainage_m = {:.6g}.",
                    chainage(seen, berm.between.crest), chainage(seen, berm.between.toe),
                    chainage(seen, berm.between.crest)));
}

void add_doubt_of_toe(std::vector<std::string>& doubts, const GroundSeen& seen, const Face& face) {
    const Polyline ground = without_holes(seen.ground, seen.scale);
    for (const double share : other_shares)
        for (const Descent& other : descents(ground, std::tan(share * face.inclination), seen.scale)) {
            if (other.crest >= face.ends.toe || other.toe <= face.ends.crest) continue;
            const double moved = std::abs(seen.ground[other.toe].x() - seen.ground[face.ends.toe].x());
            const bool main_part = drop_of(ground, other) >= face.height / 2;
            if (!main_part || moved <= apart * seen.scale) continue;
            doubts.push_back(
                fmt::format("The toe of the cut is not sharp: it was taken to be at chainage {:.6g}, but "
                            "could as well be at {:.6g}; "
                            "give section.toe_chainage_m if you know it.",
                            chainage(seen, face.ends.toe), chainage(seen, other.toe)));
            return;
        }
}

}  // namespace

std::vector<std::string> doubts_about(const GroundSeen& seen, const std::vector<Face>& faces) {
    std::vector<std::string> doubts;
    add_doubt_of_others(doubts, seen, faces);
    add_doubt_of_berm(doubts, seen, faces.front());
    if (doubts.empty()) add_doubt_of_toe(doubts, seen, faces.front());
    return doubts;
}

void add_doubt_of_other_side(std::vector<std::string>& doubts, const Face& chosen, const GroundSeen& other,
                             const Face& face) {
    if (face.weight < other_side * chosen.weight) return;
    doubts.push_back(
        fmt::format("The section has a slope on either side; the other one, {}, is what soil would run "
                    "towards or past: name it if "
                    "it is the cut.",
                    described_with_key(other, face)));
}

std::vector<std::string> doubts_about_given_toe(const GroundSeen& seen, const Face& face, std::size_t toe) {
    const double beyond = seen.ground[toe].x() - seen.ground[face.ends.toe].x();
    if (beyond <= given_apart * seen.scale) return {};
    return {fmt::format(
        "The given toe lies {:.3g} m beyond the foot of the descent {}; the run-out counts from the given "
        "toe.",
        beyond, described(seen, face))};
}

}  // namespace runout
