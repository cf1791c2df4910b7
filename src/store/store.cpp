#include "store/store.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

#include "core/input_error.h"
#include "store/database.h"
#include "store/database_file.h"
#include "store/database_in_use.h"
#include "store/effect_rows.h"
#include "store/frame_rows.h"
#include "store/known_tables.h"
#include "store/ladder_rows.h"
#include "store/record.h"
#include "store/run_places.h"
#include "store/run_rows.h"
#include "store/write_scenario.h"

namespace runout {

struct Store::Impl {
    std::string path;
    Mode mode;
    std::unique_ptr<SQLite::Database> database;
    std::function<bool()> on_wait{};

    /// What `use` makes of the database, with the database's own errors said as sentences.
    template <class Use>
    auto with_database(const Use& use) const {
        try {
            return use(*database);
        } catch (const SQLite::Exception& error) {
            throw_storage_error(path, error);
        } catch (const DamagedData& damage) {
            throw InputError({.file = path, .line = 0, .key = {}, .value = {}}, damage.what(),
                             "take a copy that is whole");
        }
    }

    /// What `use` writes, in one transaction; tried again while the file is in use, as on_wait says.
    template <class Use>
    auto write(const Use& use) const {
        if (mode == Mode::read) throw std::logic_error("a write to a store that was opened for reading");
        while (true) {
            try {
                return with_database([&](SQLite::Database& writing) {
                    // Immediate: a second writer waits here, and not halfway, where SQLite could only refuse
                    // it.
                    SQLite::Transaction transaction(writing, SQLite::TransactionBehavior::IMMEDIATE);
                    const auto written = use(writing);
                    transaction.commit();
                    return written;
                });
            } catch (const DatabaseInUse&) {
                if (!on_wait || !on_wait()) throw;
            }
        }
    }
};

Store::Store(const std::string& path, Mode mode)
    : impl_(std::make_unique<Impl>(
          Impl{path, mode, mode == Mode::read ? open_for_reading(path) : open_for_writing(path)})) {}

Store::~Store() = default;

long Store::add(const Scene& scene, const RunResult& result, const Appraisal& appraisal,
                const std::vector<PilotRow>& pilots) {
    return add({scene, result, describe_run(scene, result, appraisal), pilots});
}

long Store::add(const EndedRun& run) {
    if (run.result.status == RunStatus::running)
        throw std::logic_error("Store::add of a run that has not ended");
    return impl_->write([&](SQLite::Database& database) {
        const long run_id = insert_run(database, scenario_row(database, run.scene), run.description);
        if (run.scene.profile.map_line) set_map_line(database, run_id, *run.scene.profile.map_line);
        insert_series(database, run_id, run.result.series);
        insert_deposit(database, run_id, run.result.deposit);
        insert_snapshots(database, run_id, run.result.snapshots);
        insert_frames(database, run_id, run.result.frames);
        insert_stages(database, run_id, run.result.stages);
        insert_phases(database, run_id, run.result.phases);
        insert_effects(database, run_id, run.description);
        insert_invariants(database, run_id, run.result.invariants);
        insert_envelope(database, run_id, run.result.envelope);
        insert_pilots(database, run_id, run.pilots);
        return run_id;
    });
}

long Store::add(const StoredLadder& ladder) {
    return impl_->write([&](SQLite::Database& database) { return insert_ladder(database, ladder); });
}

std::vector<StoredLadder> Store::ladders() const {
    return impl_->with_database([](SQLite::Database& database) { return select_ladders(database); });
}

std::optional<StoredLadder> Store::find_ladder(const std::string& question_hash) const {
    return impl_->with_database(
        [&](SQLite::Database& database) { return select_ladder_of(database, question_hash); });
}

std::vector<PilotRow> Store::pilots(long run_id) const {
    return impl_->with_database([=](SQLite::Database& database) { return select_pilots(database, run_id); });
}

long Store::begin_study(const std::string& name, const std::string& text) {
    return impl_->write([&](SQLite::Database& database) { return study_row(database, name, text); });
}

void Store::set_study_scenarios(long study_id, const std::vector<StudyScenario>& rows) {
    impl_->write([&](SQLite::Database& database) {
        runout::set_study_scenarios(database, study_id, rows);
        return rows.size();
    });
}

void Store::set_sections(const SectionsTaken& sections) {
    impl_->write([&](SQLite::Database& database) {
        runout::set_sections(database, sections);
        return sections.taken.size();
    });
}

std::vector<RefusedSection> Store::refused_sections() const {
    return impl_->with_database([](SQLite::Database& database) { return select_refused_sections(database); });
}

std::vector<StoredStudy> Store::studies() const {
    return impl_->with_database([](SQLite::Database& database) { return select_studies(database); });
}

std::vector<StudyRow> Store::study_rows(long study_id) const {
    return impl_->with_database(
        [=](SQLite::Database& database) { return select_study_rows(database, study_id); });
}

std::vector<ChartRow> Store::chart_rows(std::optional<long> study_id) const {
    return impl_->with_database(
        [=](SQLite::Database& database) { return select_chart_rows(database, study_id); });
}

std::vector<ReachRow> Store::reach(const ReachQuestion& question) const {
    return impl_->with_database([&](SQLite::Database& database) { return select_reach(database, question); });
}

std::optional<Envelope> Store::envelope(long run_id) const {
    return impl_->with_database(
        [=](SQLite::Database& database) { return select_envelope(database, run_id); });
}

void Store::set_patience(std::chrono::milliseconds patience) {
    impl_->database->setBusyTimeout(static_cast<int>(patience.count()));
}

void Store::set_on_wait(std::function<bool()> on_wait) {
    impl_->on_wait = std::move(on_wait);
}

MergeCounts Store::merge(const std::string& path) {
    if (std::filesystem::exists(path) && std::filesystem::equivalent(path, impl_->path))
        throw InputError({.file = path, .line = 0, .key = {}, .value = {}}, "is the database to merge into",
                         "give other databases");
    const std::vector<std::string> foreign = check_whole(path);
    return impl_->with_database([&](SQLite::Database& database) {
        SQLite::Statement attach(database, "ATTACH DATABASE ? AS shard");
        attach.bind(1, read_only_uri(path));
        attach.exec();
        try {
            SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
            MergeCounts counts = merge_attached(database, path);
            transaction.commit();
            database.exec("DETACH DATABASE shard");
            counts.foreign = foreign;
            counts.lacks_log = lacks_its_log(path);
            return counts;
        } catch (...) {
            database.exec("DETACH DATABASE shard");
            throw;
        }
    });
}

std::vector<StoredRun> Store::runs() const {
    return impl_->with_database([](SQLite::Database& database) {
        std::vector<StoredRun> runs = select_runs(database);
        select_places(database, runs);
        return runs;
    });
}

StoredRun Store::run(long run_id) const {
    const auto found = impl_->with_database([=](SQLite::Database& database) {
        std::vector<StoredRun> runs = select_runs(database, run_id);
        for (StoredRun& run : runs) select_effects(database, run);
        return runs;
    });
    if (found.empty())
        throw InputError({.file = impl_->path, .line = 0, .key = "run_id", .value = std::to_string(run_id)},
                         "no such run", "`runout table` lists the stored runs");
    return found.front();
}

std::vector<StoredRun> Store::runs_on_section(long section_id) const {
    auto found = impl_->with_database(
        [=](SQLite::Database& database) { return select_runs_on_section(database, section_id); });
    if (found.empty())
        throw InputError(
            {.file = impl_->path, .line = 0, .key = "section_id", .value = std::to_string(section_id)},
            "no run on such a section", "`runout report --run` shows the section of a run");
    return found;
}

std::optional<long> Store::find_run(const std::string& scenario_hash) const {
    return impl_->with_database(
        [&](SQLite::Database& database) { return select_run_of(database, scenario_hash); });
}

std::vector<Snapshot> Store::snapshots(long run_id) const {
    return impl_->with_database(
        [=](SQLite::Database& database) { return select_snapshots(database, run_id); });
}

std::vector<Frame> Store::frames(long run_id) const {
    return impl_->with_database([=](SQLite::Database& database) { return select_frames(database, run_id); });
}

SectionGeometry Store::geometry(long run_id) const {
    return impl_->with_database(
        [=](SQLite::Database& database) { return select_geometry(database, run_id); });
}

std::vector<StoredFact> Store::facts(long run_id) const {
    return impl_->with_database([=](SQLite::Database& database) { return select_facts(database, run_id); });
}

std::vector<StoredTable> Store::further_tables(long run_id) const {
    return impl_->with_database(
        [=](SQLite::Database& database) { return select_further_tables(database, run_id); });
}

std::vector<StageRow> Store::stages(long run_id) const {
    return impl_->with_database([=](SQLite::Database& database) { return select_stages(database, run_id); });
}

std::vector<SeriesRow> Store::series(long run_id) const {
    return impl_->with_database([=](SQLite::Database& database) { return select_series(database, run_id); });
}

std::vector<DepositRow> Store::deposit(long run_id) const {
    return impl_->with_database([=](SQLite::Database& database) { return select_deposit(database, run_id); });
}

std::vector<PhaseTime> Store::phases(long run_id) const {
    return impl_->with_database([=](SQLite::Database& database) { return select_phases(database, run_id); });
}

std::vector<InvariantRow> Store::invariants(long run_id) const {
    return impl_->with_database(
        [=](SQLite::Database& database) { return select_invariants(database, run_id); });
}

std::optional<RunPlace> Store::place(long run_id) const {
    return impl_->with_database([=](SQLite::Database& database) { return select_place(database, run_id); });
}

Question Store::question(long run_id) const {
    return impl_->with_database(
        [=](SQLite::Database& database) { return select_question(database, run_id); });
}

}  // namespace runout
