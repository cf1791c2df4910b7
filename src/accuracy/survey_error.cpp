#include "accuracy/survey_error.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "accuracy/convergence.h"

namespace runout {
namespace {

constexpr double coverage_factor = 2.0;
// The error of a scene bounds 95 % of its own runs. With the scenes of the survey left out one after another,
// eight in ten make the bars hold for 95 % of all runs (BarsHoldOnEachSceneThatWasLeftOut).
constexpr double covered_scenes = 0.8;
constexpr double calm_unrest = 0.05;  // chosen likewise; 0.02 to 0.1 do nearly as well

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
    error.unrest = unrest_of(scene);
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

/// The value that eight in ten of another draw are expected to keep within.
double eight_in_ten(std::vector<double> values) {
    std::ranges::sort(values);
    const auto rank =
        static_cast<std::size_t>(std::ceil(covered_scenes * static_cast<double>(values.size() + 1)));
    return values[std::min(rank, values.size()) - 1];
}

std::vector<double> unrests(const std::vector<SurveyError::SceneError>& scenes) {
    std::vector<double> values;
    for (const SurveyError::SceneError& scene : scenes) values.push_back(scene.unrest);
    return values;
}

}  // namespace

double unrest_of(const SurveyedScene& scene) {
    const RungValue &coarse = scene.rungs[0].values[0], &fine = scene.rungs[1].values[0];
    return std::hypot(fine.mean - coarse.mean, coarse.scatter, fine.scatter) / size_of(scene.rungs.back());
}

double SurveyError::SceneError::at(double resolution) const {
    return interpolated(resolutions, shares, resolution);
}

SurveyError::SurveyError(const std::vector<SurveyedScene>& survey) {
    if (survey.empty()) throw std::invalid_argument("a survey without a scene tells no error");
    for (const SurveyedScene& scene : survey) {
        run_out_.push_back(error_of(scene, 0));
        reach_angle_.push_back(error_of(scene, 1));
    }
}

double SurveyError::share(const std::vector<SceneError>& scenes, double resolution, double unrest) {
    std::vector<double> ratios;
    for (const SceneError& scene : scenes)
        ratios.push_back(scene.at(resolution) / (scene.unrest + calm_unrest));
    return eight_in_ten(std::move(ratios)) * (unrest + calm_unrest);
}

double SurveyError::finest() const {
    double finest = 0.0;
    for (const SceneError& scene : run_out_) finest = std::max(finest, scene.resolutions.back());
    return finest;
}

double SurveyError::run_out_share(double resolution, double unrest) const {
    return share(run_out_, resolution, unrest);
}

double SurveyError::reach_angle_share(double resolution, double unrest) const {
    return share(reach_angle_, resolution, unrest);
}

double SurveyError::usual_unrest() const {
    std::vector<double> values = unrests(run_out_);
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

double SurveyError::high_unrest() const {
    return eight_in_ten(unrests(run_out_));
}

}  // namespace runout
