#pragma once

#include <vector>

#include "accuracy/survey.h"

namespace runout {

/// How much the run-out of a scene changes between its two coarsest spacings and from lattice to lattice
/// there, as a share of the scale: root of squares of the change of the means and of both scatters.
double unrest_of(const SurveyedScene& scene);

/// How far one run with some spacing may be from the limit (95 %), learned from the ladders of a survey. What
/// tells most of a scene is its unrest u, which coarse pilots show: where they scatter, finer runs do. So the
/// error of each scene of the survey is held against u + 0.05, and what this ratio stays below in eight
/// scenes of ten goes with the unrest of the scene that is asked for. Of fewer than nine scenes it is the
/// worst.
class SurveyError {
  public:
    /// Of one scene: on each rung its distance from the finest one, what that one may be off for its spacing
    /// (`spacing_error`), and two standard deviations of the lattices, as root of squares; never less than on
    /// a finer rung. Between the rungs it is interpolated in logarithms; beyond the finest, where nothing is
    /// known, it stays. Shares of the scale.
    struct SceneError {
        double unrest = 0;
        std::vector<double> resolutions, shares;  ///< of the rungs, resolutions rising

        [[nodiscard]] double at(double resolution) const;
    };

    /// Throws std::invalid_argument where there is no scene, or one of fewer than three rungs.
    explicit SurveyError(const std::vector<SurveyedScene>& survey);

    /// As a share of the run-out (of sqrt(S) where that is more), for a scene of this unrest.
    [[nodiscard]] double run_out_share(double resolution, double unrest) const;
    /// As a share of the reach angle.
    [[nodiscard]] double reach_angle_share(double resolution, double unrest) const;
    /// That of the scene in the middle, and what eight in ten stay below.
    [[nodiscard]] double usual_unrest() const;
    [[nodiscard]] double high_unrest() const;
    [[nodiscard]] int scenes() const { return static_cast<int>(run_out_.size()); }
    /// The finest resolution of any scene.
    [[nodiscard]] double finest() const;

  private:
    static double share(const std::vector<SceneError>& scenes, double resolution, double unrest);

    std::vector<SceneError> run_out_, reach_angle_;
};

}  // namespace runout
