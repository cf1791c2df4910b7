#include "accuracy/survey_error.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "accuracy/convergence.h"

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

/// What the finest rung may still be off for its spacing, in the unit of the quantity.
double rest_of(const SurveyedScene& scene, std::size_t quantity) {
    std::vector<RungValue> values;
    for (const RungSummary& rung : scene.rungs) values.push_back(rung.values[quantity]);
    const double rest = spacing_error(judge_convergence(values, 0.0), values.back().spacing);
    if (!std::isfinite(rest))
        throw std::invalid_argument("a survey needs three rungs of " + scene.name + " or more");
    return rest;
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

SurveyError::SceneError error_of(const SurveyedScene& scene, std::size_t quantity) {
    const double scale = scale_of(scene, quantity);
    const RungValue& finest = scene.rungs.back().values[quantity];
    const double rest = rest_of(scene, quantity);
    SurveyError::SceneError error;
    for (const RungSummary& rung : scene.rungs) {
        const RungValue& value = rung.values[quantity];
        error.resolutions.push_back(rung.resolution);
        error.shares.push_back(std::hypot(value.mean - finest.mean, rest, coverage_factor * value.scatter) /
                               scale);
    }
    // A coarse run that happens to hit is luck.
    for (std::size_t k = error.shares.size() - 1; k-- > 0;)
        error.shares[k] = std::max(error.shares[k], error.shares[k + 1]);
    return error;
}

}  // namespace

double SurveyError::SceneError::at(double resolution) const {
    return interpolated(resolutions, shares, resolution);
}

SurveyError::SurveyError(const std::vector<SurveyedScene>& survey) : survey_(survey) {
    if (survey_.empty()) throw std::invalid_argument("a survey without a scene tells no error");
    for (const SurveyedScene& scene : survey_) {
        run_out_.push_back(error_of(scene, 0));
        reach_angle_.push_back(error_of(scene, 1));
    }
}

double SurveyError::worst(const std::vector<SceneError>& scenes, double resolution) {
    double worst = 0.0;
    for (const SceneError& scene : scenes) worst = std::max(worst, scene.at(resolution));
    return worst;
}

double SurveyError::finest() const {
    double finest = 0.0;
    for (const SceneError& scene : run_out_) finest = std::max(finest, scene.resolutions.back());
    return finest;
}

double SurveyError::run_out_share(double resolution) const {
    return worst(run_out_, resolution);
}

double SurveyError::reach_angle_share(double resolution) const {
    return worst(reach_angle_, resolution);
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
