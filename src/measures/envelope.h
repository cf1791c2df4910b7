#pragma once

#include <vector>

#include "measures/measures.h"
#include "measures/reach.h"

namespace runout {

/// Keeps the greatest of what passed each place of the section, at the nodes of the thickness: steps of a
/// third of the window, whatever the spacing. A look costs a few operations a node and no memory.
class EnvelopeRecorder {
  public:
    /// `density`: of the soil, kg/m3. `start`: has looked at the release.
    EnvelopeRecorder(double density, const ReachRecorder& start);

    /// After `reach` has looked at `state`.
    void look(const ReachRecorder& reach, const StateView& state);

    [[nodiscard]] Envelope envelope() const;

  private:
    struct Node {
        double thickness = 0, speed_2 = 0,
               flux = 0;  ///< greatest; speed where the soil is as thick as a front
        double arrival;
        double final_thickness = 0, passed = 0;
    };

    [[nodiscard]] long beyond_at_start(long node) const;
    void make_room(long first, long last);

    double density_, gravity_ = 0, step_;
    long start_first_node_;
    std::vector<long> beyond_at_start_;  ///< particles at or beyond each node
    long first_node_ = 0;
    std::vector<Node> nodes_;
};

}  // namespace runout
