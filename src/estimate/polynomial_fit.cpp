#include "estimate/polynomial_fit.h"

#include <Eigen/QR>
#include <limits>
#include <optional>

namespace runout {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;
using Exponents = std::vector<std::vector<int>>;

void add_exponents(Exponents& all, std::vector<int>& begun, int left, const std::vector<int>& highest) {
    if (begun.size() == highest.size()) {
        all.push_back(begun);
        return;
    }
    for (int power = 0; power <= std::min(left, highest[begun.size()]); ++power) {
        begun.push_back(power);
        add_exponents(all, begun, left - power, highest);
        begun.pop_back();
    }
}

Exponents exponents_up_to(int degree, const std::vector<int>& highest) {
    Exponents all;
    std::vector<int> begun;
    add_exponents(all, begun, degree, highest);
    return all;
}

/// P_0 to P_degree, by Bonnet's recursion.
VectorXd legendre(double x, int degree) {
    VectorXd values(degree + 1);
    values[0] = 1;
    if (degree > 0) values[1] = x;
    for (int n = 1; n < degree; ++n)
        values[n + 1] = ((2 * n + 1) * x * values[n] - n * values[n - 1]) / (n + 1);
    return values;
}

RowVectorXd terms_at(const VectorXd& place, const Exponents& exponents, int degree) {
    std::vector<VectorXd> powers;
    for (const double x : place) powers.push_back(legendre(x, degree));
    RowVectorXd row = RowVectorXd::Ones(static_cast<Index>(exponents.size()));
    for (std::size_t term = 0; term < exponents.size(); ++term)
        for (std::size_t k = 0; k < powers.size(); ++k)
            row[static_cast<Index>(term)] *= powers[k][exponents[term][k]];
    return row;
}

}  // namespace

PolynomialFit::PolynomialFit(const SurfaceData& data, int degree, const std::vector<int>& highest)
    : degree_(degree) {
    const Exponents candidates = exponents_up_to(degree, highest);
    MatrixXd matrix(data.at.rows(), static_cast<Index>(candidates.size()));
    for (Index i = 0; i < matrix.rows(); ++i)
        matrix.row(i) = terms_at(data.at.row(i).transpose(), candidates, degree);
    Eigen::ColPivHouseholderQR<MatrixXd> qr;
    qr.setThreshold(1e-8);
    qr.compute(matrix);
    const Index rank = qr.rank();
    for (Index k = 0; k < rank; ++k)
        exponents_.push_back(candidates[static_cast<std::size_t>(qr.colsPermutation().indices()[k])]);
    triangle_ = qr.matrixR().topLeftCorner(rank, rank).triangularView<Eigen::Upper>();
    const MatrixXd q = qr.householderQ() * MatrixXd::Identity(matrix.rows(), rank);
    const VectorXd projected = q.transpose() * data.values;
    coefficients_ = triangle_.triangularView<Eigen::Upper>().solve(projected);
    leverages_ = q.rowwise().squaredNorm();
    left_out_errors_ = data.values - q * projected;
    for (Index i = 0; i < left_out_errors_.size(); ++i) {
        const double share = 1 - leverages_[i];
        left_out_errors_[i] =
            share > 1e-9 ? left_out_errors_[i] / share : std::numeric_limits<double>::infinity();
    }
}

RowVectorXd PolynomialFit::row(const VectorXd& place) const {
    return terms_at(place, exponents_, degree_);
}

double PolynomialFit::value(const VectorXd& place) const {
    return row(place).dot(coefficients_);
}

double PolynomialFit::leverage(const VectorXd& place) const {
    return triangle_.transpose().triangularView<Eigen::Lower>().solve(row(place).transpose()).squaredNorm();
}

PolynomialFit best_polynomial(const SurfaceData& data, const std::vector<int>& highest) {
    PolynomialFit best(data, 1, highest);
    for (int degree = 2; degree <= highest_degree; ++degree) {
        const auto terms = static_cast<Index>(exponents_up_to(degree, highest).size());
        if (data_per_term * terms > data.values.size()) break;
        PolynomialFit fit(data, degree, highest);
        if (fit.left_out_errors().squaredNorm() < best.left_out_errors().squaredNorm()) best = std::move(fit);
    }
    return best;
}

}  // namespace runout
