#include "profile/find_face.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "core/units.h"

namespace runout {
namespace {

constexpr double nearly_vertical = radians(85.0);
constexpr double flattest_face = radians(15.0);
constexpr double similar_weight = 0.6;
constexpr double same_toe = 0.1;  // of the relief

// Where the search for the inclination of the face begins.
constexpr std::array<double, 4> first_guesses = {radians(20.0), radians(40.0), radians(60.0), radians(90.0)};
constexpr std::size_t most_of_a_guess = 4;
constexpr int most_steps = 8;

/// Drop of the vertical parts, m.
double drop_of_walls(const Polyline& ground, const Descent& ends) {
    double drop = 0;
    for (std::size_t i = ends.crest; i < ends.toe; ++i) {
        const Vec2 d = ground[i + 1] - ground[i];
        if (std::atan2(-d.y(), d.x()) >= nearly_vertical) drop -= d.y();
    }
    return drop;
}

Face face_of(const Polyline& ground, const Descent& ends) {
    Face face{ends, drop_of(ground, ends), 0, 0};
    const double run = run_of(ground, ends);
    const double slanting = face.height - drop_of_walls(ground, ends);
    face.inclination = slanting > 1e-9 * face.height ? std::atan2(slanting, run) : std::numbers::pi / 2;
    face.weight = face.height * std::pow(face.height / std::hypot(face.height, run), 3);
    return face;
}

bool heavier(const Face& a, const Face& b) {
    return a.weight != b.weight ? a.weight > b.weight : a.ends.toe < b.ends.toe;
}

/// Descents for one slope after another, each looked for once.
class Search {
  public:
    explicit Search(const Polyline& ground)
        : relief_(relief_of(ground)), ground_(without_holes(ground, relief_)) {}

    [[nodiscard]] double relief() const { return relief_; }

    /// Faces steeper than half of `inclination`, heaviest first. Gaps in them are measured against `scale`,
    /// m.
    const std::vector<Face>& faces(double inclination, double scale) {
        const auto [found, fresh] = found_.try_emplace({inclination, scale});
        std::vector<Face>& list = found->second;
        if (!fresh) return list;
        for (const Descent& ends : descents(ground_, std::tan(inclination / 2), scale))
            list.push_back(face_of(ground_, ends));
        std::ranges::sort(list, heavier);
        return list;
    }

    /// The face about `face` whose parts are steeper than half of its own inclination and whose gaps are
    /// small against its own height; none if it is no cut.
    std::optional<Face> settled(Face face) {
        for (int step = 0; step < most_steps; ++step) {
            const Face* next = nearest_to(face, faces(face.inclination, scale_of(face, relief_)));
            if (next == nullptr) return std::nullopt;
            if (next->ends == face.ends) break;
            face = *next;
        }
        const double mean = std::atan2(face.height, run_of(ground_, face.ends));
        if (mean < flattest_face) return std::nullopt;
        return face;
    }

  private:
    /// The one that has most of the drop of `face` in common with it.
    [[nodiscard]] const Face* nearest_to(const Face& face, const std::vector<Face>& list) const {
        const Face* nearest = nullptr;
        double most = 0;
        for (const Face& other : list) {
            const Descent common{std::max(face.ends.crest, other.ends.crest),
                                 std::min(face.ends.toe, other.ends.toe)};
            if (common.crest >= common.toe || !(drop_of(ground_, common) > most)) continue;
            most = drop_of(ground_, common);
            nearest = &other;
        }
        return nearest;
    }

    double relief_;
    Polyline ground_;
    std::map<std::pair<double, double>, std::vector<Face>> found_;
};

/// The heaviest, or a similar one whose toe is further uphill: a run-out that counts from there is the longer
/// one.
void put_the_chosen_first(const Polyline& ground, double relief, std::vector<Face>& faces) {
    std::ranges::sort(faces, heavier);
    std::size_t chosen = 0;
    for (std::size_t i = 1; i < faces.size(); ++i) {
        const double uphill = ground[faces[chosen].ends.toe].x() - ground[faces[i].ends.toe].x();
        if (faces[i].weight >= similar_weight * faces.front().weight && uphill > same_toe * relief)
            chosen = i;
    }
    const auto at = faces.begin() + static_cast<long>(chosen);
    if (!faces.empty()) std::rotate(faces.begin(), at, at + 1);
}

}  // namespace

double scale_of(const Face& face, double relief) {
    return std::min(face.height, relief);
}

FaceSearch find_faces(const Polyline& ground) {
    FaceSearch result;
    Search search(ground);
    result.relief = search.relief();
    if (!(result.relief > 0)) return result;
    for (const double guess : first_guesses) {
        const std::vector<Face> begun = search.faces(guess, result.relief);
        for (std::size_t i = 0; i < std::min(begun.size(), most_of_a_guess); ++i) {
            const std::optional<Face> face = search.settled(begun[i]);
            const auto same = [&](const Face& other) { return other.ends == face->ends; };
            if (face && std::ranges::none_of(result.faces, same)) result.faces.push_back(*face);
        }
    }
    put_the_chosen_first(ground, result.relief, result.faces);
    return result;
}

}  // namespace runout
