#include "study/distribution.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <boost/math/distributions/lognormal.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/triangular.hpp>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>

namespace runout {
namespace {

using Eigen::MatrixXd;

/// Quantile of the part of a distribution between two ends.
template <class Law>
double cut_quantile(const Law& law, const Distribution& d, double probability) {
    const double below = std::isinf(d.low) ? 0.0 : boost::math::cdf(law, d.low);
    const double up_to = std::isinf(d.high) ? 1.0 : boost::math::cdf(law, d.high);
    const double value = boost::math::quantile(law, below + probability * (up_to - below));
    return std::clamp(value, d.low, d.high);
}

/// Mean and deviation of the logarithm from those of the quantity.
boost::math::lognormal lognormal_law(const Distribution& d) {
    const double variance = std::log1p(d.deviation * d.deviation / (d.mean * d.mean));
    return {std::log(d.mean) - 0.5 * variance, std::sqrt(variance)};
}

/// Uniform in [0, 1). The standard library leaves its own to the maker of the compiler.
double uniform(std::mt19937_64& random) {
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

std::vector<int> shuffled(int count, std::mt19937_64& random) {
    std::vector<int> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    for (int k = count - 1; k > 0; --k) {
        const auto other = static_cast<int>(uniform(random) * (k + 1));
        std::swap(order[static_cast<std::size_t>(k)], order[static_cast<std::size_t>(other)]);
    }
    return order;
}

/// Place of each value when they are sorted.
std::vector<int> ranks(const Eigen::VectorXd& values) {
    std::vector<int> order(static_cast<std::size_t>(values.size()));
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](int i) { return values[i]; });
    std::vector<int> rank(order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        rank[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
    return rank;
}

/// Normal scores in random order: columns that are nearly uncorrelated.
MatrixXd normal_scores(int samples, Eigen::Index columns, std::mt19937_64& random) {
    const boost::math::normal law;
    MatrixXd scores(samples, columns);
    for (Eigen::Index j = 0; j < columns; ++j) {
        const std::vector<int> order = shuffled(samples, random);
        for (int i = 0; i < samples; ++i)
            scores(i, j) =
                boost::math::quantile(law, (order[static_cast<std::size_t>(i)] + 1.0) / (samples + 1.0));
    }
    return scores;
}

MatrixXd correlation_of(const MatrixXd& columns) {
    const MatrixXd centred = columns.rowwise() - columns.colwise().mean();
    const MatrixXd covariance = centred.transpose() * centred;
    const Eigen::VectorXd inverse = covariance.diagonal().cwiseSqrt().cwiseInverse();
    return inverse.asDiagonal() * covariance * inverse.asDiagonal();
}

/// Sorts each column so that its ranks are those of scores with the wanted correlation.
void reorder(MatrixXd& table, const MatrixXd& lower, std::mt19937_64& random) {
    const auto samples = static_cast<int>(table.rows());
    MatrixXd scores = normal_scores(samples, table.cols(), random);
    const Eigen::LLT<MatrixXd> own(correlation_of(scores));
    if (own.info() == Eigen::Success)
        scores = scores * own.matrixU().solve(MatrixXd::Identity(table.cols(), table.cols()));
    scores = scores * lower.transpose();
    for (Eigen::Index j = 0; j < table.cols(); ++j) {
        std::vector<double> sorted(table.col(j).begin(), table.col(j).end());
        std::ranges::sort(sorted);
        const std::vector<int> rank = ranks(scores.col(j));
        for (int i = 0; i < samples; ++i)
            table(i, j) = sorted[static_cast<std::size_t>(rank[static_cast<std::size_t>(i)])];
    }
}

}  // namespace

double quantile(const Distribution& d, double probability) {
    // A law without ends has none at 0 and 1.
    probability = std::clamp(probability, 1e-18, 1 - 0x1p-53);
    switch (d.shape) {
        case Distribution::Shape::normal:
            return cut_quantile(boost::math::normal(d.mean, d.deviation), d, probability);
        case Distribution::Shape::lognormal: {
            Distribution positive = d;
            positive.low = std::max(0.0, d.low);
            return cut_quantile(lognormal_law(d), positive, probability);
        }
        case Distribution::Shape::triangular:
            return boost::math::quantile(boost::math::triangular(d.low, d.mode, d.high), probability);
        case Distribution::Shape::uniform:
            return d.low + probability * (d.high - d.low);
    }
    throw std::invalid_argument("unknown distribution");
}

void check_share(const Factor& factor) {
    const auto* d = std::get_if<Distribution>(&factor.values);
    if (d == nullptr) return;
    bool has_share = d->shape != Distribution::Shape::lognormal || d->high > 0;
    try {
        const double low = has_share ? quantile(*d, 1e-6) : 0, high = has_share ? quantile(*d, 1 - 1e-6) : 0;
        has_share = std::isfinite(low) && std::isfinite(high) && low < high;
    } catch (const std::exception&) {  // Boost's, of arguments that no law takes
        has_share = false;
    }
    if (!has_share)
        throw InputError(factor.place, "is a distribution that nothing can be drawn from",
                         "give ends within a few deviations of the mean, and numbers of one size");
}

MatrixXd latin_hypercube(int samples, const MatrixXd& rank_correlation, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    MatrixXd table(samples, rank_correlation.cols());
    for (Eigen::Index j = 0; j < table.cols(); ++j) {
        const std::vector<int> order = shuffled(samples, random);
        for (int i = 0; i < samples; ++i)
            table(i, j) =
                (order[static_cast<std::size_t>(i)] + std::clamp(uniform(random), 1e-12, 1 - 1e-12)) /
                samples;
    }
    if (rank_correlation.isIdentity() || samples < 2) return table;
    // Of two normal scores with correlation r the rank correlation is 6/pi asin(r/2) (Pearson 1907).
    constexpr double pi = 3.14159265358979323846;
    const MatrixXd of_scores = (2 * (pi / 6 * rank_correlation.array()).sin()).matrix();
    const Eigen::LLT<MatrixXd> factor(of_scores);
    if (factor.info() != Eigen::Success)
        throw std::invalid_argument("the correlation is not positive definite");
    reorder(table, factor.matrixL(), random);
    return table;
}

}  // namespace runout
