#include "estimate/convex_hull.h"

#include <Eigen/QR>
#include <vector>

namespace runout {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Non-negative least squares by an active set (Lawson and Hanson 1974, chapter 23): the weights w >= 0 that
/// make |A w - b| least. Few weights are ever above zero, as many as A has rows, so a step costs a product
/// with A.
class NonNegativeLeastSquares {
  public:
    NonNegativeLeastSquares(const MatrixXd& matrix, const VectorXd& wanted)
        : matrix_(matrix), wanted_(wanted), weights_(VectorXd::Zero(matrix.cols())) {}

    VectorXd residual(double tolerance) {
        const Index most_steps = 3 * matrix_.cols() + 10;
        for (Index step = 0; step < most_steps && remaining().norm() > tolerance; ++step) {
            const VectorXd gradient = matrix_.transpose() * remaining();
            Index best = -1;
            for (Index j = 0; j < gradient.size(); ++j)
                if (!is_free(j) && gradient[j] > 1e-12 && (best < 0 || gradient[j] > gradient[best]))
                    best = j;
            if (best < 0) break;  // no weight that would bring it nearer
            free_.push_back(best);
            solve_free();
        }
        return remaining();
    }

  private:
    [[nodiscard]] VectorXd remaining() const { return wanted_ - matrix_ * weights_; }
    [[nodiscard]] bool is_free(Index j) const {
        for (const Index k : free_)
            if (k == j) return true;
        return false;
    }

    /// Weights of the free columns by least squares; those that would fall below zero leave.
    void solve_free() {
        while (!free_.empty()) {
            MatrixXd columns(matrix_.rows(), static_cast<Index>(free_.size()));
            for (std::size_t k = 0; k < free_.size(); ++k)
                columns.col(static_cast<Index>(k)) = matrix_.col(free_[k]);
            const VectorXd target = columns.colPivHouseholderQr().solve(wanted_);
            if (target.minCoeff() > 0) {
                for (std::size_t k = 0; k < free_.size(); ++k)
                    weights_[free_[k]] = target[static_cast<Index>(k)];
                return;
            }
            go_towards(target);
        }
    }

    /// As far as no weight becomes negative; those that are zero then are free no more.
    void go_towards(const VectorXd& target) {
        double share = 1;
        std::size_t first_out = 0;
        for (std::size_t k = 0; k < free_.size(); ++k) {
            const double now = weights_[free_[k]], then = target[static_cast<Index>(k)];
            if (then > 0 || now / (now - then) > share) continue;
            share = now / (now - then);
            first_out = k;
        }
        for (std::size_t k = 0; k < free_.size(); ++k)
            weights_[free_[k]] += share * (target[static_cast<Index>(k)] - weights_[free_[k]]);
        weights_[free_[first_out]] = 0;
        std::erase_if(free_, [&](Index j) { return weights_[j] <= 0; });
    }

    const MatrixXd& matrix_;
    const VectorXd& wanted_;
    VectorXd weights_;
    std::vector<Index> free_;
};

}  // namespace

bool in_convex_hull(const MatrixXd& points, const VectorXd& place, double tolerance) {
    MatrixXd matrix(points.cols() + 1, points.rows());
    matrix << points.transpose(), Eigen::RowVectorXd::Ones(points.rows());
    VectorXd wanted(place.size() + 1);
    wanted << place, 1;
    return NonNegativeLeastSquares(matrix, wanted).residual(tolerance).lpNorm<Eigen::Infinity>() <= tolerance;
}

}  // namespace runout
