#include "stress/latin_hypercube.h"

#include <numeric>
#include <random>
#include <utility>

namespace runout {
namespace {

// The distributions and the shuffle of the standard library differ from one to another.
double uniform(std::mt19937_64& random) {
    return static_cast<double>(random() >> 11U) * 0x1.0p-53;
}

std::vector<int> shuffled(int count, std::mt19937_64& random) {
    std::vector<int> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    for (int k = count - 1; k > 0; --k)
        std::swap(order[k], order[static_cast<int>(uniform(random) * (k + 1))]);
    return order;
}

}  // namespace

std::vector<std::vector<double>> latin_hypercube(int count, int dimensions, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::vector<std::vector<double>> points(static_cast<std::size_t>(count),
                                            std::vector<double>(static_cast<std::size_t>(dimensions)));
    for (int d = 0; d < dimensions; ++d) {
        const std::vector<int> slice = shuffled(count, random);
        for (int k = 0; k < count; ++k) points[k][d] = (slice[k] + uniform(random)) / count;
    }
    return points;
}

}  // namespace runout
