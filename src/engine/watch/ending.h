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

    /// Soil as it is now, not yet moving; also after more has been added.
    void start(const Soil& soil, double time);
    /// Ends the run where a law of physics is broken or soil leaves the section.
    void judge(const SoilSurvey& soil, const InvariantWatch& invariants, const BedLine& bed, double time);
    /// Whether the soil has come to rest, the run not having ended.
    [[nodiscard]] bool at_rest(const Soil& soil, double time);
    /// Ends the run at rest: as one that settled, or, where no particle has got far, as one that stood.
    void end_at_rest(const Soil& soil, const std::vector<Vec2>& starts);
    /// Ends the run if it has lasted as long as it may.
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
