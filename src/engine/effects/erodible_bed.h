#pragma once

#include <vector>

#include "engine/effects.h"
#include "engine/particles/soil.h"

namespace runout {

/// The same layer with its depth rounded to whole particles, at least one. A layer of one and a half would
/// start squeezed.
ErodibleBed with_whole_particles(ErodibleBed layer, double spacing);

/// Outline of the layer, counter-clockwise: between the ground and the same lowered by its depth.
Polygon layer_outline(const Polyline& ground, const ErodibleBed& layer);

/// The ground without the layer.
Polyline lowered_by(const Polyline& ground, const ErodibleBed& layer);

/// Which soil of the layer still lies where it lay.
class UnmovedLayer {
  public:
    /// `first_id`, `end_id`: of the layer's soil.
    UnmovedLayer(int first_id, int end_id, double spacing);

    /// To be called after each step. Soil that has moved by two spacings counts as debris from then on.
    /// `starts`: positions at release by id, m.
    void observe(const Soil& soil, const std::vector<Vec2>& starts);

    /// Per soil particle: 1 where it has not moved.
    [[nodiscard]] const std::vector<char>& unmoved() const { return unmoved_; }
    /// Particles that have moved.
    [[nodiscard]] long moved() const;

  private:
    int first_id_, end_id_;
    double far2_;              ///< m2
    std::vector<char> moved_;  ///< by id since first_id_
    std::vector<char> unmoved_;
};

}  // namespace runout
