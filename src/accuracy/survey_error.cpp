#include "accuracy/survey_error.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace runout {
namespace {

constexpr double coverage_factor = 2.0;

double size_of(const RungSummary& finest) {
    return std::max(finest.values[0].mean, finest.spacing_m * finest.resolution);
}

double scale_of(const SurveyedScene& scene, std::size_t quantity) {
    const RungSummary& finest = scene.rungs.back();
    return quantity == 0 ? size_of(finest) : std::abs(finest.values[quantity].mean);
}

/// Error of one run on a rung against the finest, a share.
double error_share(const SurveyedScene& scene, const RungSummary& rung, std::size_t quantity) {
    const RungValue& value = rung.values[quantity];
    const double off = value.mean - scene.rungs.back().values[quantity].mean;
    return std::hypot(off, coverage_factor * value.scatter) / scale_of(scene, quantity);
}

/// Value of a function that is known at rising places, straight in logarithms.
double interpolated(const std::vector<double>& at, const std::vector<double>& values, double place) {
    const auto next = std::ranges::lower_bound(at, place);
    if (next == at.begin()) return values.front();
    if (next == at.end()) return values.back();
    const auto k = static_cast<std::size_t>(next - at.begin());
    const double share = std::log(place / at[k - 1]) / std::log(at[k] / at[k - 1]);
    return std::exp((1 - share) * std::log(values[k - 1]) + share * std::log(values[k]));
}

std::vector<double> envelope(const std::vector<SurveyedScene>& survey, const std::vector<double>& resolutions,
                             std::size_t quantity) {
    std::vector<double> worst(resolutions.size(), 0.0);
    for (const SurveyedScene& scene : survey)
        for (const RungSummary& rung : scene.rungs)
            for (std::size_t k = 0; k < resolutions.size(); ++k)
                // A rung speaks for every coarser resolution: a coarse run that happens to hit is luck.
                if (resolutions[k] <= rung.resolution)
                    worst[k] = std::max(worst[k], error_share(scene, rung, quantity));
    return worst;
}

}  // namespace

SurveyError::SurveyError(const std::vector<SurveyedScene>& survey) : survey_(survey) {
    std::set<double> known;
    for (const SurveyedScene& scene : survey_)
        for (const RungSummary& rung : scene.rungs) known.insert(rung.resolution);
    if (known.empty()) throw std::invalid_argument("a survey without a rung tells no error");
    resolutions_.assign(known.begin(), known.end());
    run_out_ = envelope(survey_, resolutions_, 0);
    reach_angle_ = envelope(survey_, resolutions_, 1);
}

double SurveyError::worst(double resolution, const std::vector<double>& envelope) const {
    const double beyond = resolution / resolutions_.back();
    return interpolated(resolutions_, envelope, resolution) / std::max(1.0, beyond);
}

double SurveyError::run_out_share(double resolution) const {
    return worst(resolution, run_out_);
}

double SurveyError::reach_angle_share(double resolution) const {
    return worst(resolution, reach_angle_);
}

double SurveyError::change_share(double coarse, double fine, int lattices) const {
    double most = 0;
    for (const SurveyedScene& scene : survey_) {
        const RungSummary *from = nullptr, *to = nullptr;
        for (const RungSummary& rung : scene.rungs) {
            if (rung.resolution == coarse) from = &rung;
            if (rung.resolution == fine) to = &rung;
        }
        if (from == nullptr || to == nullptr) continue;
        const RungValue &a = from->values[0], &b = to->values[0];
        const double noise =
            coverage_factor * std::hypot(a.scatter, b.scatter) / std::sqrt(std::max(1, lattices));
        most = std::max(most, std::hypot(b.mean - a.mean, noise) / size_of(scene.rungs.back()));
    }
    return most;
}

}  // namespace runout
