#pragma once

#include <string>
#include <vector>

#include "engine/particles/bed_line.h"
#include "engine/particles/soil.h"
#include "engine/status.h"
#include "engine/watch/invariants.h"
#include "engine/watch/rest_watch.h"

namespace runout {

/// Whether and why a run ends; see docs/stability.md.
class Ending {
  public:
    /// `length`: sqrt(S), m; `time_limit`: s since soil was last let go.
    Ending(double gravity, double length, double spacing, double time_limit);

    /// To be called at the start and after soil has been added: the soil as it is now, not yet moving.
    void start(const Soil& soil, double time);
    /// Ends the run where an invariant is violated, the pressure equation is not solved, or soil leaves the
    /// section.
    void judge(const SoilSurvey& soil, const InvariantWatch& invariants, const BedLine& bed, double time);
    /// Whether the soil has come to rest; false if the run has ended.
    [[nodiscard]] bool at_rest(const Soil& soil, double time);
    /// Ends the run at rest: as `stable` where no particle has moved by two spacings, else as `settled`.
    void end_at_rest(const Soil& soil, const std::vector<Vec2>& starts);
    /// Ends the run if its time limit is reached.
    void judge_time(double time);

    [[nodiscard]] RunStatus status() const { return status_; }
    /// Why the run did not settle, one sentence; empty otherwise.
    [[nodiscard]] const std::string& detail() const { return detail_; }
    [[nodiscard]] const RestWatch& rest() const { return rest_; }
    [[nodiscard]] double time_limit() const { return time_limit_; }

  private:
    void end(RunStatus status, std::string detail = {});

    RestWatch rest_;
    double spacing_;
    double time_limit_;
    double stage_start_ = 0;  ///< s
    RunStatus status_ = RunStatus::running;
    std::string detail_;
};

}  // namespace runout
