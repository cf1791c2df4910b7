#pragma once

#include <vector>

#include "engine/pairs/neighbours.h"
#include "engine/particles/soil.h"
#include "engine/particles/wall.h"

namespace runout {

/// Soil and bed as particles, and who is near whom.
struct ParticleSystem {
    Soil soil;
    Wall wall;
    Neighbours neighbours;
};

/// A vector per node, see Neighbours.
struct NodeVectors {
    std::vector<double> x, y;
};

}  // namespace runout
