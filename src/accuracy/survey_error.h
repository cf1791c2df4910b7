#pragma once

#include <vector>

#include "accuracy/survey.h"

namespace runout {

/// How far one run with some spacing may be from the limit (95 %), by the ladders of a survey: the worst of
/// all scenes.
class SurveyError {
  public:
    /// Of one scene: on each rung its distance from the finest one, what that one may be off for its spacing
    /// (`spacing_error`), and two standard deviations of the lattices, as root of squares; never less than on
    /// a finer rung. Between the rungs it is interpolated in logarithms; beyond the finest, where nothing is
    /// known, it stays. Shares of the scale.
    struct SceneError {
        std::vector<double> resolutions, shares;  ///< of the rungs, resolutions rising

        [[nodiscard]] double at(double resolution) const;
    };

    /// Throws std::invalid_argument where there is no scene, or one of fewer than three rungs.
    explicit SurveyError(const std::vector<SurveyedScene>& survey);

    /// As a share of the run-out (of sqrt(S) where that is more).
    [[nodiscard]] double run_out_share(double resolution) const;
    /// As a share of the reach angle.
    [[nodiscard]] double reach_angle_share(double resolution) const;
    /// The most that the run-out changed between two resolutions, as a share; with the scatter of both means
    /// over so many lattices.
    [[nodiscard]] double change_share(double coarse, double fine, int lattices) const;
    [[nodiscard]] int scenes() const { return static_cast<int>(survey_.size()); }
    /// The finest resolution of any scene.
    [[nodiscard]] double finest() const;

  private:
    static double worst(const std::vector<SceneError>& scenes, double resolution);

    std::vector<SurveyedScene> survey_;
    std::vector<SceneError> run_out_, reach_angle_;
};

}  // namespace runout
