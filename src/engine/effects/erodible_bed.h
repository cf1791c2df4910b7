#pragma once

#include <vector>

#include "engine/effects/effects.h"
#include "engine/particles/soil.h"

namespace runout {

/// The same layer as deep as the nearest whole number of particles, at least one: a layer of one and a half
/// would start squeezed.
ErodibleBed with_whole_rows(ErodibleBed layer, double spacing);

/// Outline of the layer, counter-clockwise: between the ground and the same lowered by its depth.
Polygon layer_outline(const Polyline& ground, const ErodibleBed& layer);

/// The ground without the layer.
Polyline lowered_by(const Polyline& ground, const ErodibleBed& layer);

/// Which soil of the layer still lies where it lay.
class RestingLayer {
  public:
    /// `first_id`, `end_id`: of the layer's soil.
    RestingLayer(int first_id, int end_id, double spacing);

    /// Soil counts as debris from when it has moved by two spacings, and stays it. `starts`: positions at
    /// release by id, m.
    void observe(const Soil& soil, const std::vector<Vec2>& starts);

    /// Per soil particle: 1 where it has not moved.
    [[nodiscard]] const std::vector<char>& resting() const { return resting_; }
    /// Particles that have moved.
    [[nodiscard]] long moved() const;

  private:
    int first_id_, end_id_;
    double far2_;              ///< m2
    std::vector<char> moved_;  ///< by id since first_id_
    std::vector<char> resting_;
};

}  // namespace runout
