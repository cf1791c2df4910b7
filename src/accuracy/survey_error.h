#pragma once

#include <vector>

#include "accuracy/survey.h"

namespace runout {

/// How far one run with some spacing may be from the finest (95 %), by the ladders of a survey: at each
/// resolution the worst of all scenes, of the distance of the rung from the finest one and two standard
/// deviations of the lattices; never less than at a finer resolution. Between the rungs it is interpolated in
/// logarithms; beyond the finest it falls in proportion to the spacing down to the least scatter.
class SurveyError {
  public:
    explicit SurveyError(const std::vector<SurveyedScene>& survey);

    /// As a share of the run-out (of sqrt(S) where that is more).
    [[nodiscard]] double run_out_share(double resolution) const;
    /// As a share of the reach angle.
    [[nodiscard]] double reach_angle_share(double resolution) const;
    /// The most that the run-out changed between two resolutions, as a share; with the scatter of both means
    /// over so many lattices.
    [[nodiscard]] double change_share(double coarse, double fine, int lattices) const;
    [[nodiscard]] int scenes() const { return static_cast<int>(survey_.size()); }
    [[nodiscard]] double finest() const { return resolutions_.back(); }

  private:
    [[nodiscard]] double worst(double resolution, const std::vector<double>& envelope) const;

    std::vector<SurveyedScene> survey_;
    std::vector<double> resolutions_;            ///< rising
    std::vector<double> run_out_, reach_angle_;  ///< envelopes at `resolutions_`
};

}  // namespace runout
