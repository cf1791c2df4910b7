#pragma once

#include <Eigen/Core>
#include <vector>

namespace runout {

/// Places and values that a surface is laid through: a row of `at` for each value, coordinates within -1 to
/// 1.
struct SurfaceData {
    Eigen::MatrixXd at;
    Eigen::VectorXd values;
};

/// Least-squares polynomial of several variables. Terms that the data cannot tell from others are left out.
class PolynomialFit {
  public:
    /// Products of Legendre polynomials of a total degree up to `degree`, in variable k up to `highest[k]`.
    PolynomialFit(const SurfaceData& data, int degree, const std::vector<int>& highest);

    [[nodiscard]] double value(const Eigen::VectorXd& place) const;
    /// Variance of the fitted value here over that of one datum: x (X'X)^-1 x'.
    [[nodiscard]] double leverage(const Eigen::VectorXd& place) const;
    [[nodiscard]] int degree() const { return degree_; }
    [[nodiscard]] Eigen::Index terms() const { return static_cast<Eigen::Index>(exponents_.size()); }

    /// Error at each datum of the surface through all others: r_i / (1 - h_ii), exactly, without fitting
    /// again (Allen 1974). Infinite where the others say nothing of the place.
    [[nodiscard]] const Eigen::VectorXd& left_out_errors() const { return left_out_errors_; }
    [[nodiscard]] const Eigen::VectorXd& leverages() const { return leverages_; }

  private:
    [[nodiscard]] Eigen::RowVectorXd row(const Eigen::VectorXd& place) const;

    int degree_;
    std::vector<std::vector<int>> exponents_;  ///< a vector for each term
    Eigen::MatrixXd triangle_;                 ///< R of X = Q R
    Eigen::VectorXd coefficients_;
    Eigen::VectorXd left_out_errors_;
    Eigen::VectorXd leverages_;
};

/// Greatest degree that is tried.
inline constexpr int highest_degree = 3;
/// Data that a term needs.
inline constexpr Eigen::Index data_per_term = 3;

/// The degree, from 1 to highest_degree, whose left-out errors have the least sum of squares. Degrees that
/// have fewer than data_per_term data a term are not tried, apart from 1.
PolynomialFit best_polynomial(const SurfaceData& data, const std::vector<int>& highest);

}  // namespace runout
