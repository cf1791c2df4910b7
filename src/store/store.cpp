#include "store/store.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>

#include <stdexcept>

#include "core/input_error.h"
#include "store/database.h"
#include "store/frame_rows.h"
#include "store/record.h"
#include "store/run_places.h"
#include "store/run_rows.h"
#include "store/write_scenario.h"

namespace runout {

struct Store::Impl {
    std::string path;
    Mode mode;
    std::unique_ptr<SQLite::Database> database;

    /// What `use` makes of the database, with the database's own errors said as sentences.
    template <class Use>
    auto with_database(const Use& use) const {
        try {
            return use(*database);
        } catch (const SQLite::Exception& error) {
            throw_storage_error(path, error);
        }
    }
};

Store::Store(const std::string& path, Mode mode)
    : impl_(std::make_unique<Impl>(
          Impl{path, mode, mode == Mode::read ? open_for_reading(path) : open_for_writing(path)})) {}

Store::~Store() = default;

long Store::add(const Scene& scene, const RunResult& result) {
    if (impl_->mode == Mode::read)
        throw std::logic_error("Store::add on a store that was opened for reading");
    if (result.status == RunStatus::running) throw std::logic_error("Store::add of a run that has not ended");
    return impl_->with_database([&](SQLite::Database& database) {
        // Immediate: a second writer waits here, and not halfway, where SQLite could only refuse it.
        SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
        const long run_id = insert_run(database, scenario_row(database, scene), describe_run(scene, result));
        if (scene.profile.map_line) set_map_line(database, run_id, *scene.profile.map_line);
        insert_series(database, run_id, result.series);
        insert_deposit(database, run_id, result.deposit);
        insert_snapshots(database, run_id, result.snapshots);
        insert_frames(database, run_id, result.frames);
        insert_stages(database, run_id, result.stages);
        insert_phases(database, run_id, result.phases);
        insert_invariants(database, run_id, result.invariants);
        transaction.commit();
        return run_id;
    });
}

std::vector<StoredRun> Store::runs() const {
    return impl_->with_database([](SQLite::Database& database) { return select_runs(database); });
}

StoredRun Store::run(long run_id) const {
    const auto found =
        impl_->with_database([=](SQLite::Database& database) { return select_runs(database, run_id); });
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
