#pragma once

#include <algorithm>
#include <random>
#include <vector>

#include "core/geometry.h"

namespace runout {

/// Sections as an engineer has them, at random: a level top, a face with berms and walls, a level foot.
class RandomSections {
  public:
    explicit RandomSections(unsigned seed) : random_(seed) {}

    Polyline next() {
        const double start = number(-50, 2000);
        Polyline section{{start, number(50, 400)}};
        go(section, number(5, 40), 0);
        const int parts = 1 + static_cast<int>(number(0, 5));
        for (int i = 0; i < parts; ++i) {
            go(section, number(2, 12), -number(3, 15));
            if (number(0, 1) < 0.3) go(section, 0, -number(1, 4));  // a wall
            if (i + 1 < parts) go(section, number(1, 4), -number(0, 0.2));
        }
        go(section, number(40, 200), -number(0, 1));
        if (number(0, 1) < 0.3) mirror(section);
        return section;
    }

    /// The section in pieces, in any order and direction, one of them twice.
    std::vector<Polyline> cut_into_pieces(const Polyline& section) {
        std::vector<Polyline> pieces;
        Polyline piece{section.front()};
        for (std::size_t i = 1; i < section.size(); ++i) {
            piece.push_back(section[i]);
            if (i + 1 < section.size() && number(0, 1) < 0.5) continue;
            pieces.push_back(piece);
            piece = {section[i]};
        }
        pieces.push_back(pieces[pick(pieces.size())]);
        std::ranges::shuffle(pieces, random_);
        for (Polyline& one : pieces)
            if (number(0, 1) < 0.5) std::ranges::reverse(one);
        return pieces;
    }

    double number(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
    std::size_t pick(std::size_t count) { return random_() % count; }

  private:
    static void go(Polyline& section, double along, double up) {
        section.emplace_back(section.back() + Vec2(along, up));
    }
    static void mirror(Polyline& section) {
        for (Vec2& p : section) p.x() = -p.x();
        std::ranges::reverse(section);
    }

    std::mt19937 random_;
};

}  // namespace runout
