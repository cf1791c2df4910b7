#pragma once

#include <Eigen/Core>

namespace runout {

/// Whether `place` is a mean of rows of `points` with weights that are not negative, to within `tolerance` in
/// each coordinate. Coordinates should be of order one.
bool in_convex_hull(const Eigen::MatrixXd& points, const Eigen::VectorXd& place, double tolerance);

}  // namespace runout
