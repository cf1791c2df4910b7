#pragma once

#include <cmath>
#include <vector>

namespace runout {

/// Tells when the state of stress at release is found: when the acceleration of the soil no longer changes
/// from round to round, or when patience ends.
class Equilibrium {
  public:
    static constexpr int rounds = 200;
    static constexpr double least_change = 5e-4;  ///< between two rounds, in g, root mean square

    Equilibrium(std::size_t particles, double gravity)
        : gravity_(gravity), ax_(particles, 0.0), ay_(particles, 0.0) {}

    /// The acceleration of particle `i` in this round, m/s2.
    void observe(std::size_t i, double ax, double ay) {
        change2_ += (ax - ax_[i]) * (ax - ax_[i]) + (ay - ay_[i]) * (ay - ay_[i]);
        ax_[i] = ax;
        ay_[i] = ay;
    }
    void end_round() {
        ++round_;
        const double change = std::sqrt(change2_ / static_cast<double>(ax_.size()));
        reached_ = change < least_change * gravity_ || round_ >= rounds;
        change2_ = 0.0;
    }
    [[nodiscard]] bool reached() const { return reached_; }

  private:
    double gravity_;
    std::vector<double> ax_, ay_;  ///< as known so far
    double change2_ = 0;
    int round_ = 0;
    bool reached_ = false;
};

}  // namespace runout
