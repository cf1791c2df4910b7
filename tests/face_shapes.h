#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "core/units.h"

namespace runout {

/// A section whose toe and crest are known, for tests: points run downhill with the chainage.
struct FaceShape {
    std::string name;
    std::vector<Vec2> points;
    std::size_t crest = 0;
    std::size_t toe = 0;

    [[nodiscard]] double relief() const { return points.front().y() - points.back().y(); }
};

/// Draws a section from its uphill end, piece by piece.
class SectionPen {
  public:
    SectionPen(std::string name, double x, double y) { shape_ = {std::move(name), {{x, y}}, 0, 0}; }

    SectionPen& down(double angle_deg, double drop) {
        const double run = angle_deg >= 90 ? 0 : drop / std::tan(radians(angle_deg));
        return go(run, -drop);
    }
    SectionPen& go(double run, double rise) {
        shape_.points.push_back(shape_.points.back() + Vec2(run, rise));
        return *this;
    }
    SectionPen& crest() {
        shape_.crest = shape_.points.size() - 1;
        return *this;
    }
    SectionPen& toe() {
        shape_.toe = shape_.points.size() - 1;
        return *this;
    }
    [[nodiscard]] FaceShape shape() const { return shape_; }

  private:
    FaceShape shape_;
};

/// Cuts of many kinds: batters, berms, retaining walls, hillsides, sloping ground below.
inline std::vector<FaceShape> face_shapes() {
    std::vector<FaceShape> shapes;
    for (const double face : {35.0, 45.0, 60.0, 72.0}) {
        const auto pen = [&](const std::string& name) { return SectionPen(name, 3.25, 60); };
        const auto add = [&](const SectionPen& drawn) { shapes.push_back(drawn.shape()); };
        add(pen("plain").go(30, 0).crest().down(face, 20).toe().go(160, 0));
        add(pen("low").go(12, 0).crest().down(face, 6).toe().go(60, 0));
        add(pen("high").go(40, 0).crest().down(face, 55).toe().go(300, 0));
        add(pen("short crest").go(2, 0).crest().down(face, 18).toe().go(120, -1));
        add(pen("hillside")
                .go(40, -40 * std::tan(radians(face / 4)))
                .crest()
                .down(face, 20)
                .toe()
                .go(160, 0));
        add(pen("sloping below")
                .go(30, -1)
                .crest()
                .down(face, 20)
                .toe()
                .go(160, -160 * std::tan(radians(5))));
        add(pen("rising below").go(30, -1).crest().down(face, 20).toe().go(160, 160 * std::tan(radians(2))));
        add(pen("berm").go(30, 0).crest().down(face, 10).go(3, -0.1).down(face, 9.9).toe().go(160, 0));
        add(pen("three berms")
                .go(30, 0)
                .crest()
                .down(face, 7.5)
                .go(1.5, 0)
                .down(face, 7.5)
                .go(3, 0)
                .down(face, 7.5)
                .go(3.5, 0)
                .down(face, 7.5)
                .toe()
                .go(200, 0));
        add(pen("wall").go(30, 0).crest().down(face, 16).down(90, 4).toe().go(160, 0));
        add(pen("wall after a strip")
                .go(30, -2)
                .crest()
                .down(face, 14)
                .go(0.8, 0)
                .down(90, 3.5)
                .toe()
                .go(90, -0.5));
        add(pen("two angles").go(30, 0).crest().down(face, 8).down(face * 0.75, 9).toe().go(150, 0));
    }
    return shapes;
}

}  // namespace runout
