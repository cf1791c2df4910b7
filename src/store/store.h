#pragma once

#include <memory>
#include <string>
#include <vector>

#include "measures/measures.h"
#include "scene/scene.h"

namespace runout {

/// Identity of a scenario: SHA-256 (hex) over everything that determines its result (ground, source, material, run
/// settings that change numbers, program version); not names, paths, thread count.
std::string scenario_hash(const Scene& scene);

/// One stored run with its scenario, as the tables and reports read it.
struct StoredRun {
    long run_id = 0;
    std::string name;
    std::string section_origin;
    std::string source_type;
    double slope_angle_deg = 0;
    double friction_angle_deg = 0;
    std::string scenario_hash;
    std::string started_utc;
    RunStatus status = RunStatus::running;
    std::string status_detail;
    Measures measures;
    RunWork work;
};

/// The results database. The file is created on the first write and never half written: one transaction a run.
/// Throws InputError: not a Runout database, a newer version, an unwritable place.
class Store {
  public:
    enum class Mode { read, write };
    Store(const std::string& path, Mode mode);
    ~Store();
    Store(const Store&) = delete;
    Store& operator=(const Store&) = delete;

    /// Returns the run's id.
    long add(const Scene& scene, const RunResult& result);
    [[nodiscard]] std::vector<StoredRun> runs() const;
    [[nodiscard]] std::vector<SeriesRow> series(long run_id) const;
    [[nodiscard]] std::vector<DepositRow> deposit(long run_id) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace runout
