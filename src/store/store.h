#pragma once

#include <chrono>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "measures/measures.h"
#include "scene/effect_settings.h"
#include "scene/scene.h"
#include "store/chart_rows.h"
#include "store/envelope_rows.h"
#include "store/merge.h"
#include "store/refused_rows.h"
#include "store/study_rows.h"

namespace runout {

/// Identity of a scenario: SHA-256 (hex) over everything that determines its result (ground, source,
/// material, run settings that change numbers, program version); not names, paths, thread count.
std::string scenario_hash(const Scene& scene);

/// A coarse run of the same scenario that was made for another run's spacing and error bar.
struct PilotRow {
    double resolution = 0;  ///< sqrt(S) / particle spacing
    double lattice_seed = 0;
    double run_out_m = 0;  ///< NaN, as the other measures, when it did not end as a result
    double reach_angle_deg = 0;
    double deposit_height_m = 0;
    double particles = 0;
    double steps = 0;
    double pressure_iterations = 0;
    double cpu_s = 0;
};

/// How sure the numbers of a run are as numbers, what that was found from, and what the run was expected to
/// take.
struct Appraisal {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    std::string accuracy_asked;              ///< "5 %"; empty: the spacing was given
    double run_out_error_m = unknown;        ///< numerical uncertainty of the run-out, 95 %
    double reach_angle_error_deg = unknown;  ///< and of the reach angle
    std::string error_origin = "none";       ///< ladder, pilot or none
    std::string error_note;                  ///< how they were found, one sentence
    double expected_cpu_s = unknown;         ///< as the cost model foretold it
    double choosing_cpu_s = 0;               ///< spent on pilots
};

/// One run with its scenario, as the tables and reports read it.
struct StoredRun {
    long run_id = 0;  ///< 0: not stored
    std::string name;
    std::string section_origin;
    std::vector<Attribute> section_attributes{};  ///< what the map said of the section line
    std::string source_type;
    double discontinuity_angle_deg = 0;  ///< of the plane that bounds front_area_m2
    std::string drop_height_datum;       ///< point of the source that drop_height_m is measured to
    double slope_angle_deg = 0;
    double toe_chainage_m = 0;
    double toe_elevation_m = 0;
    double crest_chainage_m = 0;
    double face_height_m = 0;     ///< crest above toe
    std::string toe_origin;       ///< found or given; empty: not known, as the run is older than the question
    std::string crest_origin;     ///< the same
    std::string section_read_as;  ///< as Profile::read_as
    std::string section_doubts;   ///< as Profile::doubts, a line each
    /// What run-out and reach angle rest on: "thickness" (docs/front.md), or "top" in runs before
    /// database 10.
    std::string front_definition = current_front_definition;
    double friction_angle_deg = 0;
    std::string scenario_hash;
    std::string started_utc;  ///< ISO 8601, "2024-05-31T09:30:00Z"
    std::string ended_utc;
    std::string program_version;
    std::string program_revision;
    std::string compiler;
    int host_threads = 0;  ///< hardware threads of the machine that ran it
    RunStatus status = RunStatus::running;
    std::string status_detail;
    Measures measures;
    RunWork work;
    // Of a run that is looked at by itself; left out where runs are listed.
    std::vector<EffectRow> effects;              ///< all that the program knows, on or off
    std::vector<EffectSetting> effect_settings;  ///< of those that were on
    std::vector<std::string> advice;
    std::vector<PlaceRecord> places;
    std::vector<BarrierRecord> barriers;  ///< one, or none
    std::string machine;                  ///< processor and hardware threads
    Appraisal appraisal;
};

/// Ground and source of a run, local frame.
struct SectionGeometry {
    long section_id = 0;
    Profile profile;  ///< its origin is the file that the run names
    Polygon outline;  ///< of the source
    Polyline bed;     ///< the ground left when the source has gone
    Vec2 exit_point{0, 0};
    Vec2 head{0, 0};
    double discontinuity_angle = 0;  ///< rad, of the plane through the exit point
};

/// Nothing, or a value as the database has it.
using StoredValue = std::variant<std::monostate, long, double, std::string>;

/// One column of the rows that belong to a run, whatever version of the format added it.
struct StoredFact {
    std::string table;    ///< run, scenario, source, section or measure
    std::string column;   ///< with its unit
    std::string meaning;  ///< the comment in db/schema.sql; empty if there is none
    StoredValue value;
};

/// Rows of a run in a table that has no reader of its own here.
struct StoredTable {
    std::string name;
    std::string meaning;  ///< the comment above the table in db/schema.sql
    std::vector<std::string> columns;
    std::vector<std::vector<StoredValue>> rows;
};

/// The run that has just ended, by this program on this machine. It is what `Store::add` writes and what is
/// told of the run; what is read of it later is equal to the bit, the id apart.
StoredRun describe_run(const Scene& scene, const RunResult& result, const Appraisal& appraisal = {});

/// A run that has ended, with all that is stored of it.
struct EndedRun {
    const Scene& scene;
    const RunResult& result;
    const StoredRun& description;  ///< of this result, by describe_run
    const std::vector<PilotRow>& pilots;
};

/// One run of a study of what accuracy costs.
struct LadderRun {
    std::string series;   ///< what was varied; "spacing" for the ladder proper
    std::string setting;  ///< its value, as in a case file
    double resolution = 0;
    long run_id = 0;
};

/// What a ladder says of one quantity; NaN where it says nothing. The columns of ladder_verdict.
struct LadderVerdict {
    std::string quantity;  ///< name of the measure
    std::string verdict;
    double finest_value = 0;
    double uncertainty = 0;
    double lattice_scatter = 0;
    double observed_order = 0;
    double richardson_value = 0;
    double grid_convergence_index = 0;
    double fitted_order = 0;
    double fitted_value = 0;
};

/// A study of one question, as it is stored.
struct StoredLadder {
    long ladder_id = 0;         ///< 0: not stored
    std::string question_hash;  ///< of all that determines the result but spacing and lattice
    std::string name;
    std::string ended_utc;  ///< empty: when it is stored
    std::string target;
    std::string machine;
    std::vector<LadderRun> runs;
    std::vector<LadderVerdict> verdicts;
};

/// Where a run took place: the section in chainages and elevations of its origin, and on the map.
struct RunPlace {
    double toe_chainage_m = 0;
    double toe_elevation_m = 0;
    bool descends_with_chainage = true;
    Polyline bed;  ///< what the source leaves and the ground before it, from the uphill to the distal end
    Polygon source_outline;
    Vec2 head{0, 0};        ///< upper end of the source on the ground
    Vec2 exit_point{0, 0};  ///< P, where the slip surface daylights
    MapLine line;
};

/// What a run was asked, apart from its ground, as JSON: equal texts are equal questions.
struct Question {
    std::string physical;   ///< kind of source, soil and effects
    std::string source;     ///< its source among those of the database
    std::string numerical;  ///< resolution, schemes and tolerances
};

/// The results database, format in db/schema.sql. One transaction a run, so nothing is ever half written; any
/// number of programs may write one file.
class Store {
  public:
    enum class Mode { read, write };

    /// Opens `path` and, for writing, makes sure that it can be written: it is created with its tables if it
    /// does not exist, and brought up to date if it is of an older version. For reading it must exist. Throws
    /// InputError: no such file, not a Runout database, a newer version, an unwritable place. It then leaves
    /// the disk as it was.
    Store(const std::string& path, Mode mode);
    ~Store();
    Store(const Store&) = delete;
    Store& operator=(const Store&) = delete;

    /// Stores a run that has ended and returns its id. Throws InputError when the disk does not let it; the
    /// database is then as before.
    long add(const EndedRun& run);
    /// Describes the run and stores it, for those who tell nothing of it.
    long add(const Scene& scene, const RunResult& result, const Appraisal& appraisal = {},
             const std::vector<PilotRow>& pilots = {});
    /// Stores a study whose runs are stored, and returns its id.
    long add(const StoredLadder& ladder);

    /// The id of the study of that name, which is made if absent. When its text has changed, what was said of
    /// its scenarios is forgotten; runs stay.
    long begin_study(const std::string& name, const std::string& text);
    void set_study_scenarios(long study_id, const std::vector<StudyScenario>& rows);
    [[nodiscard]] std::vector<StoredStudy> studies() const;
    /// The scenarios of a study with the latest run of each, in the order of the study.
    [[nodiscard]] std::vector<StudyRow> study_rows(long study_id) const;
    /// The scenarios of a study, or all, as a run-out chart needs them.
    [[nodiscard]] std::vector<ChartRow> chart_rows(std::optional<long> study_id) const;

    /// What stored runs say of a place.
    [[nodiscard]] std::vector<ReachRow> reach(const ReachQuestion& question) const;
    /// None: the run is older than envelopes.
    [[nodiscard]] std::optional<Envelope> envelope(long run_id) const;

    /// How long a write waits for another program before it throws DatabaseInUse; 30 s unless said otherwise.
    void set_patience(std::chrono::milliseconds patience);
    /// Called each time a write has waited for that long: true lets it try again, so that what has ended is
    /// not lost.
    void set_on_wait(std::function<bool()> on_wait);

    /// Copies what is missing here from the results database at `path` (see store/merge.h). All or nothing.
    /// Throws InputError, naming the one of the two that is at fault.
    MergeCounts merge(const std::string& path);

    /// All runs in the order they were stored.
    [[nodiscard]] std::vector<StoredRun> runs() const;
    /// Throws InputError when there is no such run.
    [[nodiscard]] StoredRun run(long run_id) const;
    /// All runs on a section, in the order they were stored. Throws InputError when there is no such section.
    [[nodiscard]] std::vector<StoredRun> runs_on_section(long section_id) const;
    /// The latest run of this scenario that the user did not interrupt.
    [[nodiscard]] std::optional<long> find_run(const std::string& scenario_hash) const;
    [[nodiscard]] std::vector<SeriesRow> series(long run_id) const;
    [[nodiscard]] std::vector<DepositRow> deposit(long run_id) const;
    [[nodiscard]] std::vector<PhaseTime> phases(long run_id) const;
    [[nodiscard]] std::vector<InvariantRow> invariants(long run_id) const;
    [[nodiscard]] std::vector<Snapshot> snapshots(long run_id) const;
    [[nodiscard]] std::vector<Frame> frames(long run_id) const;
    [[nodiscard]] std::vector<StageRow> stages(long run_id) const;
    [[nodiscard]] std::vector<PilotRow> pilots(long run_id) const;
    /// All studies in the order they were stored.
    [[nodiscard]] std::vector<StoredLadder> ladders() const;
    /// Notes which of the sections of a layer that were asked for were refused, and why.
    void set_sections(const SectionsTaken& sections);
    /// What was refused and not taken since.
    [[nodiscard]] std::vector<RefusedSection> refused_sections() const;
    /// The latest study of this question.
    [[nodiscard]] std::optional<StoredLadder> find_ladder(const std::string& question_hash) const;
    /// None when the section came from a CSV, which does not say where it lies.
    [[nodiscard]] std::optional<RunPlace> place(long run_id) const;
    [[nodiscard]] Question question(long run_id) const;

    // What a report prints without knowing every column.
    [[nodiscard]] SectionGeometry geometry(long run_id) const;
    [[nodiscard]] std::vector<StoredFact> facts(long run_id) const;
    [[nodiscard]] std::vector<StoredTable> further_tables(long run_id) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace runout
