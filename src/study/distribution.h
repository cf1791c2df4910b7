#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "study/study_file.h"

namespace runout {

/// The value below which a share `probability` (0 to 1, ends excluded) of the distribution lies.
double quantile(const Distribution& distribution, double probability);

/// Throws InputError where `factor` is sampled and its distribution has no share that could be told between
/// its ends, such as a normal one of 35 +- 2 between 1000 and 1001.
void check_share(const Factor& factor);

/// Latin hypercube (McKay, Beckman and Conover 1979): `samples` probabilities in each column, one in each of
/// as many equal strata, in random order. Where `rank_correlation` (columns x columns, ones on its diagonal)
/// is not the identity the columns are reordered towards it (Iman and Conover 1982), which leaves each of
/// them as it is. The same on every machine for a seed. Throws std::invalid_argument when the correlation is
/// not positive definite.
Eigen::MatrixXd latin_hypercube(int samples, const Eigen::MatrixXd& rank_correlation, std::uint64_t seed);

}  // namespace runout
