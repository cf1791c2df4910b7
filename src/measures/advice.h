#pragma once

#include <string>
#include <vector>

#include "engine/simulation.h"
#include "scene/scene.h"

namespace runout {

/// Watches for effects that a case does not name and that might matter: says so with the number, and changes
/// nothing.
class Advisor {
  public:
    /// `interval`: between looks, s.
    Advisor(const Scene& scene, double interval);

    void look(const Simulation& simulation);

    /// One sentence each; empty when there is nothing to say.
    [[nodiscard]] std::vector<std::string> sentences() const;

  private:
    void look_at_rate(const Simulation& simulation);

    bool rate_;
    double source_height_;     ///< m
    double holding_cohesion_;  ///< Pa; infinite where cohesion is on
    double density_;
    double interval_;
    double due_ = 0;
    double fast_share_ = 0, fast_number_ = 0, fast_time_ = 0;
};

}  // namespace runout
