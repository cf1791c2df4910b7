#include "measures/thickness.h"

#include <algorithm>
#include <cmath>

namespace runout {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

/// 15/16 (1 - u^2)^2 for |u| < 1; its integral is 1.
double kernel(double u) {
    const double left = 1.0 - u * u;
    return left > 0.0 ? 0.9375 * left * left : 0.0;
}
constexpr double kernel_peak = 0.9375;
constexpr double most_curved_down = 3.75, most_curved_up = 7.5;  // greatest -K'' and K''

}  // namespace

ThicknessField::ThicknessField(const FrontRule& rule, std::vector<BedWall> walls)
    : rule_(rule), step_(rule.window / nodes_per_window), walls_(std::move(walls)) {}

ThicknessField::ThicknessField(const FrontRule& rule, const StateView& state)
    : ThicknessField(rule, walls_of(*state.ground, *state.bed, rule.threshold)) {}

bool ThicknessField::counts(const StateView& state, std::size_t i) const {
    return state.is_debris(i) && std::isfinite(state.x[i]) && std::isfinite(state.y[i]);
}

void ThicknessField::take(const StateView& state) {
    spreads_.clear();
    limits_.clear();
    nodes_.clear();
    area_ = state.discretisation->volume();
    first_x_ = state.ground->points().front().x() - rule_.window;
    last_x_ = state.ground->points().back().x() + rule_.window;
    double low = endless, high = -endless;
    for (std::size_t i = 0; i < state.x.size(); ++i) {
        if (!counts(state, i)) continue;
        low = std::min(low, state.x[i]);
        high = std::max(high, state.x[i]);
    }
    if (!(low <= high)) return;
    low = std::clamp(low, first_x_, last_x_) - rule_.window;
    high = std::clamp(high, first_x_, last_x_) + rule_.window;
    first_node_ = static_cast<long>(std::floor(low / step_));
    const auto last = static_cast<long>(std::ceil(high / step_));
    nodes_.resize(static_cast<std::size_t>(last - first_node_ + 1));
    for (std::size_t i = 0; i < state.x.size(); ++i)
        if (counts(state, i))
            add(std::clamp(state.x[i], first_x_, last_x_), state.y[i], state.vx[i], state.vy[i]);
    for (const Spread& spread : spreads_) add_to_nodes(spread);
    count_beyond();
    std::ranges::sort(limits_);
}

void ThicknessField::add(double x, double y, double vx, double vy) {
    const double place = x / step_ - static_cast<double>(first_node_);
    ++nodes_[static_cast<std::size_t>(place)].beyond;
    double low = -endless, high = endless;
    for (const BedWall& wall : walls_) {
        if (wall.top.y() <= y) continue;
        const double face = wall.x_at(y);
        if (std::abs(face - x) >= rule_.window) continue;
        if (wall.rises && face >= x) high = std::min(high, face);
        if (!wall.rises && face <= x) low = std::max(low, face);
    }
    // In a slot that is narrow for the window the soil is held back at its far side only.
    if (high - low < 0.5 * rule_.window) low = -endless;
    spreads_.push_back({x, vx, vy, low, high, false});
    if (high < endless) {
        spreads_.push_back({2 * high - x, vx, vy, low, high, true});
        limits_.push_back(high);
    }
    if (low > -endless) spreads_.push_back({2 * low - x, vx, vy, low, high, true});
    if (low > -endless && high < endless) {  // thrown back twice
        spreads_.push_back({x + 2 * (high - low), vx, vy, low, high, true});
        spreads_.push_back({x - 2 * (high - low), vx, vy, low, high, true});
    }
}

void ThicknessField::add_to_nodes(const Spread& spread) {
    const double base = static_cast<double>(first_node_);
    const double last = static_cast<double>(nodes_.size()) - 1.0;
    const double from = std::max(std::max(spread.x - rule_.window, spread.low) / step_ - base, 0.0);
    const double to = std::min(std::min(spread.x + rule_.window, spread.high) / step_ - base, last);
    if (to < 0.0 || from > last) return;
    const double inverse = 1.0 / nodes_per_window;
    const double at = spread.x / step_ - base;
    for (auto k = static_cast<long>(std::ceil(from)); k <= static_cast<long>(to); ++k) {
        const double weight = kernel((static_cast<double>(k) - at) * inverse);
        Node& node = nodes_[static_cast<std::size_t>(k)];
        node.weight += weight;
        node.momentum_x += weight * spread.vx;
        node.momentum_y += weight * spread.vy;
        ++node.reached_by;
    }
}

/// So far each node has the particles between it and the next.
void ThicknessField::count_beyond() {
    long beyond = 0;
    for (auto node = nodes_.rbegin(); node != nodes_.rend(); ++node) node->beyond = beyond += node->beyond;
}

SoilColumn ThicknessField::column(double weight, double momentum_x, double momentum_y) const {
    SoilColumn column;
    if (!(weight > 0.0)) return column;
    column.thickness = weight * area_ / rule_.window;
    column.velocity = Vec2(momentum_x, momentum_y) / weight;
    return column;
}

SoilColumn ThicknessField::node(std::size_t i) const {
    return column(nodes_[i].weight, nodes_[i].momentum_x, nodes_[i].momentum_y);
}

SoilColumn ThicknessField::at(double x) const {
    double weight = 0, momentum_x = 0, momentum_y = 0;
    for (const Spread& spread : spreads_) {
        if (x < spread.low || x > spread.high) continue;
        const double share = kernel((x - spread.x) / rule_.window);
        weight += share;
        momentum_x += share * spread.vx;
        momentum_y += share * spread.vy;
    }
    return column(weight, momentum_x, momentum_y);
}

double ThicknessField::area_beyond(double x) const {
    const auto count = std::ranges::count_if(
        spreads_, [x](const Spread& spread) { return spread.x >= x && !spread.is_image; });
    return static_cast<double>(count) * area_;
}

double ThicknessField::front() const {
    for (std::size_t left = nodes_.empty() ? 0 : nodes_.size() - 1; left-- > 0;) {
        if (!may_hold_front(left)) continue;
        const double x = static_cast<double>(first_node_ + static_cast<long>(left)) * step_;
        const double found = front_between(x, x + step_);
        if (found > nowhere) return found;
    }
    return nowhere;
}

/// Between two nodes h exceeds the greater of them by no more than its curvature allows, unless soil that is
/// held back by a wall ends there.
bool ThicknessField::may_hold_front(std::size_t left) const {
    const Node& a = nodes_[left];
    const Node& b = nodes_[left + 1];
    const double unit = area_ / rule_.window;
    const double curvature = static_cast<double>(a.reached_by + b.reached_by) * most_curved_down;
    const double rise = curvature / (8.0 * nodes_per_window * nodes_per_window);
    if (unit * (std::max(a.weight, b.weight) + rise) >= rule_.threshold) return true;
    const double x = static_cast<double>(first_node_ + static_cast<long>(left)) * step_;
    const auto limit = std::ranges::lower_bound(limits_, x);
    return limit != limits_.end() && *limit <= x + step_;
}

double ThicknessField::front_between(double left, double right) const {
    near_.clear();
    for (const Spread& spread : spreads_)
        if (spread.x > left - rule_.window && spread.x < right + rule_.window && spread.high >= left &&
            spread.low <= right)
            near_.push_back(spread);
    if (static_cast<double>(near_.size()) * kernel_peak * area_ / rule_.window < rule_.threshold)
        return nowhere;
    // Soil that a wall holds back ends at once, and not smoothly: each such end begins a new stretch.
    double end = right;
    for (auto limit = std::ranges::upper_bound(limits_, right); limit != limits_.begin();) {
        --limit;
        if (*limit < left) break;
        if (*limit == end) continue;
        const double found = front_in_smooth(std::nextafter(*limit, endless), end, near_);
        if (found > nowhere) return found;
        end = *limit;
    }
    return front_in_smooth(left, end, near_);
}

/// From the right, by steps that h cannot have reached the threshold within: what bounds it is the parabola
/// through value and slope with the greatest curvature that these particles can have.
double ThicknessField::front_in_smooth(double left, double right, const std::vector<Spread>& near) const {
    constexpr double rounding = 1e-12;
    const double w = rule_.window;
    const double curvature = static_cast<double>(near.size()) * most_curved_up / (w * w);
    const double wanted = rule_.threshold * w / area_ * (1.0 - rounding);
    for (double x = right; x >= left;) {
        double value = 0, slope = 0;
        for (const Spread& spread : near) {
            const double u = (x - spread.x) / w;
            if (u * u >= 1.0 || x < spread.low || x > spread.high) continue;
            value += kernel(u);
            slope -= 4.0 * kernel_peak * u * (1.0 - u * u) / w;
        }
        if (value >= wanted) return x;
        if (near.empty()) return nowhere;
        const double step =
            (slope + std::sqrt(slope * slope + 2.0 * curvature * (wanted - value))) / curvature;
        // Far from the toe the digits of x are coarser than any share of the window.
        x = std::min(x - std::max(step, rounding * w), std::nextafter(x, nowhere));
    }
    return nowhere;
}

}  // namespace runout
