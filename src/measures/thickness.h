#pragma once

#include <limits>
#include <vector>

#include "engine/state_view.h"
#include "measures/bed_walls.h"
#include "measures/front_rule.h"

namespace runout {

/// The column of soil at one place: thickness and velocity averaged over depth, both over the window.
struct SoilColumn {
    double thickness = 0;  ///< m
    Vec2 velocity{0, 0};   ///< m/s; zero where there is no soil
};

/// Thickness of all soil over horizontal distance, single grains included: each particle's area is spread by
/// the kernel 15/16 (1 - (u/w)^2)^2 / w, |u| < w, and h(x) is their sum. A particle before a wall that stands
/// higher than it (bed_walls.h) is spread up to the wall only; what would go through is thrown back.
/// docs/front.md. Takes memory once and then keeps it.
class ThicknessField {
  public:
    static constexpr double nowhere = -std::numeric_limits<double>::infinity();
    static constexpr int nodes_per_window = 3;

    ThicknessField(const FrontRule& rule, std::vector<BedWall> walls);
    /// For a state whose bed does not change.
    ThicknessField(const FrontRule& rule, const StateView& state);

    /// Reads off the debris of a state; all below is of that.
    void take(const StateView& state);

    /// By summing over all particles.
    [[nodiscard]] SoilColumn at(double x) const;
    /// Farthest x at which h is at least the threshold, hanging together with the rest or not; `nowhere`.
    [[nodiscard]] double front() const;
    /// Area of the debris at or beyond x, m2.
    [[nodiscard]] double area_beyond(double x) const;
    [[nodiscard]] const FrontRule& rule() const { return rule_; }

    // At equal steps of x, multiples of `node_step` from the toe, wherever there is soil.
    [[nodiscard]] double node_step() const { return step_; }
    [[nodiscard]] long first_node() const { return first_node_; }
    [[nodiscard]] std::size_t nodes() const { return nodes_.size(); }
    [[nodiscard]] SoilColumn node(std::size_t i) const;
    /// Particles at or beyond a node, and the area of one.
    [[nodiscard]] long beyond_node(std::size_t i) const { return nodes_[i].beyond; }
    [[nodiscard]] double particle_area() const { return area_; }

  private:
    /// A particle or its image behind a wall, with the part of the line that it is spread over.
    struct Spread {
        double x, vx, vy;
        double low, high;
        bool is_image;
    };
    struct Node {
        double weight = 0, momentum_x = 0, momentum_y = 0;  ///< sums of kernel and kernel times velocity
        long reached_by = 0;                                ///< spreads that reach it
        long beyond = 0;
    };

    [[nodiscard]] bool counts(const StateView& state, std::size_t i) const;
    void add(double x, double y, double vx, double vy);
    void add_to_nodes(const Spread& spread);
    void count_beyond();
    [[nodiscard]] SoilColumn column(double weight, double momentum_x, double momentum_y) const;
    [[nodiscard]] bool may_hold_front(std::size_t left) const;
    [[nodiscard]] double front_between(double left, double right) const;
    [[nodiscard]] double front_in_smooth(double left, double right, const std::vector<Spread>& near) const;

    FrontRule rule_;
    double step_;
    std::vector<BedWall> walls_;
    double area_ = 0;
    double first_x_ = 0, last_x_ = 0;  ///< soil beyond is put there: a run that leaves the section ends
    long first_node_ = 0;
    std::vector<Node> nodes_;
    std::vector<Spread> spreads_;
    std::vector<double> limits_;        ///< right ends of spreads at walls
    mutable std::vector<Spread> near_;  ///< room for the search of the front
};

}  // namespace runout
