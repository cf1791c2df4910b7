#include "accuracy/cost_model.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace runout {
namespace {

using Coefficients = Eigen::Vector3d;

/// Multipliers of the three coefficients.
Coefficients terms(const CostSample& sample) {
    return {sample.steps, sample.steps * sample.particles, sample.pressure_iterations * sample.particles};
}

/// Least squares with the coefficients that are not in `used` held at zero.
Coefficients fit_some(const Eigen::MatrixX3d& matrix, unsigned used) {
    Eigen::MatrixX3d part = matrix;
    for (int k = 0; k < 3; ++k)
        if ((used >> k & 1U) == 0) part.col(k).setZero();
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(matrix.rows());
    // Scaled columns: the terms differ by many orders of magnitude.
    Coefficients scale = part.colwise().norm();
    scale = scale.unaryExpr([](double norm) { return norm > 0 ? 1.0 / norm : 0.0; });
    const Eigen::MatrixX3d scaled = part * scale.asDiagonal();
    return scale.cwiseProduct(Coefficients(scaled.completeOrthogonalDecomposition().solve(ones)));
}

/// Power of the resolution that the steps grow with.
double step_exponent(std::span<const CostSample> samples) {
    constexpr double usual = 1.0, least = 0.7, most = 1.4;
    constexpr double least_span = 1.4;  // half an octave
    const auto [low, high] = std::ranges::minmax(samples, {}, &CostSample::resolution);
    if (!(high.resolution >= least_span * low.resolution) || !(low.steps > 0)) return usual;
    double xx = 0, xy = 0, x_mean = 0, y_mean = 0;
    const double count = static_cast<double>(samples.size());
    for (const CostSample& sample : samples) {
        x_mean += std::log(sample.resolution) / count;
        y_mean += std::log(sample.steps) / count;
    }
    for (const CostSample& sample : samples) {
        const double x = std::log(sample.resolution) - x_mean;
        xx += x * x;
        xy += x * (std::log(sample.steps) - y_mean);
    }
    return std::clamp(xy / xx, least, most);
}

/// The samples with the resolution nearest to `resolution`, averaged.
CostSample nearest(std::span<const CostSample> samples, double resolution) {
    const auto distance = [&](const CostSample& sample) {
        return std::abs(std::log(sample.resolution / resolution));
    };
    const double least = distance(*std::ranges::min_element(samples, {}, distance));
    CostSample mean;
    double count = 0;
    for (const CostSample& sample : samples) {
        if (distance(sample) > least + 1e-9) continue;
        mean.resolution += sample.resolution;
        mean.particles += sample.particles;
        mean.steps += sample.steps;
        mean.pressure_iterations += sample.pressure_iterations;
        mean.peak_memory_mb = std::max(mean.peak_memory_mb, sample.peak_memory_mb);
        ++count;
    }
    mean.resolution /= count;
    mean.particles /= count;
    mean.steps /= count;
    mean.pressure_iterations /= count;
    return mean;
}

double expected_memory(std::span<const CostSample> samples, double particles) {
    const auto [low, high] = std::ranges::minmax(samples, {}, &CostSample::particles);
    const double span = high.particles - low.particles;
    const double slope = span > 0 ? std::max(0.0, (high.peak_memory_mb - low.peak_memory_mb) / span) : 0.0;
    return high.peak_memory_mb + slope * std::max(0.0, particles - high.particles);
}

}  // namespace

CostSample cost_sample(double resolution, const RunWork& work) {
    return {resolution,
            static_cast<double>(work.particles),
            static_cast<double>(work.steps),
            static_cast<double>(work.pressure_iterations),
            work.cpu_s,
            work.peak_memory_mb};
}

double CostModel::cpu_seconds(const CostSample& counts) const {
    return terms(counts).dot(Coefficients(per_step_s, per_particle_step_s, per_particle_iteration_s));
}

CostModel fit_cost_model(std::span<const CostSample> samples) {
    std::vector<CostSample> timed;
    for (const CostSample& sample : samples)
        if (sample.cpu_s > 0 && sample.steps > 0) timed.push_back(sample);
    if (timed.empty()) throw std::invalid_argument("a cost model needs a run that took time");
    Eigen::MatrixX3d matrix(static_cast<Eigen::Index>(timed.size()), 3);
    for (std::size_t i = 0; i < timed.size(); ++i)
        matrix.row(static_cast<Eigen::Index>(i)) = terms(timed[i]).transpose() / timed[i].cpu_s;
    Coefficients best = Coefficients::Zero();
    double least = std::numeric_limits<double>::infinity();
    for (unsigned used = 1; used < 8; ++used) {
        const Coefficients fitted = fit_some(matrix, used);
        const double rest = (matrix * fitted).array().operator-(1.0).matrix().squaredNorm();
        if (fitted.minCoeff() < 0 || !(rest < least)) continue;
        least = rest;
        best = fitted;
    }
    return {best[0], best[1], best[2]};
}

CostSample expected_counts(std::span<const CostSample> samples, double resolution) {
    if (samples.empty()) throw std::invalid_argument("nothing to expect a cost from");
    CostSample counts = nearest(samples, resolution);
    const double finer = resolution / counts.resolution;
    const double more_steps = std::pow(finer, step_exponent(samples));
    counts.resolution = resolution;
    counts.particles *= finer * finer;
    counts.steps *= more_steps;
    counts.pressure_iterations *= more_steps;
    counts.peak_memory_mb = expected_memory(samples, counts.particles);
    return counts;
}

CostSample expected_cost(std::span<const CostSample> samples, const CostModel& model, double resolution) {
    double measured = 0, modelled = 0;
    for (const CostSample& sample : samples) {
        measured += sample.cpu_s;
        modelled += model.cpu_seconds(sample);
    }
    CostSample cost = expected_counts(samples, resolution);
    const double slower = measured > 0 && modelled > 0 ? measured / modelled : 1.0;
    cost.cpu_s = slower * model.cpu_seconds(cost);
    return cost;
}

}  // namespace runout
