#include "stress/hillside.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace runout {
namespace {

constexpr int arc_pieces = 6;
constexpr int step_count = 40;

/// Walks from a start by lengths and falls below the horizontal.
class Walk {
  public:
    explicit Walk(const Vec2& start) : points_{start} {}

    void go(double length, double fall_angle) {
        if (length <= 0) return;
        // cos(90 deg) is not quite zero, and an overhang is refused.
        const double along = fall_angle > std::numbers::pi / 2 - 1e-9 ? 0.0 : length * std::cos(fall_angle);
        points_.emplace_back(points_.back() + Vec2(along, -length * std::sin(fall_angle)));
    }
    void turn(double length, double from, double to) {
        for (int k = 0; k < arc_pieces; ++k)
            go(length / arc_pieces, from + (to - from) * (k + 0.5) / arc_pieces);
    }
    std::vector<Vec2>& points() { return points_; }

  private:
    std::vector<Vec2> points_;
};

void go_down_the_face(Walk& walk, const Hillside& h, double length) {
    switch (h.shape) {
        case HillsideShape::convex_crest:
            walk.turn(0.3 * length, 0.0, h.face_angle);
            walk.go(0.7 * length, h.face_angle);
            return;
        case HillsideShape::concave_toe:
            walk.go(0.7 * length, h.face_angle);
            walk.turn(0.3 * length, h.face_angle, h.run_out_angle);
            return;
        case HillsideShape::retaining_wall:
            walk.go(std::max(0.0, length - h.detail / std::sin(h.face_angle)), h.face_angle);
            walk.go(h.detail, std::numbers::pi / 2);
            return;
        case HillsideShape::berms:
            for (int k = 0; k < 3; ++k) {
                walk.go(length / 3, h.face_angle);
                if (k < 2) walk.go(h.detail, 0.0);
            }
            return;
        default:
            walk.go(length, h.face_angle);
    }
}

void go_along_the_run_out(Walk& walk, const Hillside& h) {
    double left = h.run_out_length;
    if (h.shape == HillsideShape::notch) {
        walk.go(h.detail, std::numbers::pi / 4);
        walk.go(h.detail, -std::numbers::pi / 4);
        left -= h.detail;
    }
    if (h.shape == HillsideShape::steps) {
        for (int k = 0; k < step_count; ++k) {
            walk.go(2 * h.detail, h.run_out_angle);
            walk.go(h.detail, std::numbers::pi / 2);
        }
        left -= 2 * h.detail * step_count;
    }
    walk.go(std::max(left, 0.2 * h.run_out_length), h.run_out_angle);
}

}  // namespace

std::string to_string(HillsideShape shape) {
    constexpr std::array names = {"plain", "retaining_wall", "concave_toe", "convex_crest",
                                  "berms", "notch",          "steps"};
    return names.at(static_cast<std::size_t>(shape));
}

double fall_of_steps(const Hillside& h) {
    return h.shape == HillsideShape::steps ? step_count * h.detail : 0.0;
}

std::vector<Vec2> ground_of(const Hillside& h) {
    Walk walk({0, 0});
    walk.go(h.bench, 0.0);
    go_down_the_face(walk, h, h.height / std::sin(h.face_angle));
    const Vec2 toe = walk.points().back();
    go_along_the_run_out(walk, h);
    for (Vec2& point : walk.points()) point -= toe;
    return walk.points();
}

}  // namespace runout
