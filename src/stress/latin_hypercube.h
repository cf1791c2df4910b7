#pragma once

#include <cstdint>
#include <vector>

namespace runout {

/// `count` points of the unit cube: along every axis each of `count` equal slices holds exactly one. The same
/// for the same seed on every machine (McKay, Beckman and Conover 1979).
std::vector<std::vector<double>> latin_hypercube(int count, int dimensions, std::uint64_t seed);

}  // namespace runout
