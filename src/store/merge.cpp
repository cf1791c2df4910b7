#include "store/merge.h"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/input_error.h"
#include "store/known_tables.h"

namespace runout {
namespace {

using SQLite::Database;
using SQLite::Statement;
using Names = std::vector<std::string>;

Names columns_of(const std::string& table) {
    return known_table(table).columns;
}

/// A table whose rows are known by a hash, whatever their ids in two databases.
struct Hashed {
    std::string table, id, hash;
    Names references;  ///< ids of other hashed tables
};

/// "shard.source.area_m2", or the id it has here where the column is one of `mapped`.
Names selected(const std::string& table, const Names& columns, const Names& mapped) {
    Names texts;
    for (const std::string& column : columns) {
        const bool is_mapped = std::ranges::find(mapped, column) != mapped.end();
        texts.push_back(
            is_mapped ? fmt::format("(SELECT new FROM temp.{0}_map WHERE old = shard.{1}.{0})", column, table)
                      : fmt::format("shard.{}.{}", table, column));
    }
    return texts;
}

Names without(Names names, const std::string& name) {
    std::erase(names, name);
    return names;
}

/// Rows that are missing, and where each row of the shard is here: temp.<id>_map (old, new).
void merge_hashed(Database& database, const Hashed& what) {
    const Names columns = without(columns_of(what.table), what.id);
    database.exec(fmt::format(
        "INSERT OR IGNORE INTO main.{0} ({1}) SELECT {2} FROM shard.{0} ORDER BY shard.{0}.{3}", what.table,
        fmt::join(columns, ", "), fmt::join(selected(what.table, columns, what.references), ", "), what.id));
    database.exec(
        fmt::format("CREATE TEMP TABLE {0}_map AS SELECT theirs.{0} AS old, ours.{0} AS new"
                    " FROM shard.{1} AS theirs JOIN main.{1} AS ours ON ours.{2} = theirs.{2};"
                    " CREATE UNIQUE INDEX temp.{0}_map_old ON {0}_map (old)",
                    what.id, what.table, what.hash));
}

/// Rows that hang on a hashed row; those that are here are the same, because the hash covers them.
void merge_parts(Database& database, const std::string& table, const std::string& id) {
    const Names columns = columns_of(table);
    database.exec(fmt::format("INSERT OR IGNORE INTO main.{0} ({1}) SELECT {2} FROM shard.{0}", table,
                              fmt::join(columns, ", "), fmt::join(selected(table, columns, {id}), ", ")));
}

void refuse_conflicts(Database& database, const std::string& from) {
    const Names columns = without(columns_of("measure"), "run_id");
    Names differences = {"theirs.status IS NOT ours.status"};
    for (const std::string& column : columns)
        differences.push_back(fmt::format("their_measure.{0} IS NOT our_measure.{0}", column));
    Statement statement(
        database, fmt::format("SELECT theirs.run_id, theirs.name, ours.run_id FROM temp.candidate"
                              " JOIN shard.run AS theirs ON theirs.run_id = candidate.old"
                              " JOIN main.run AS ours ON ours.run_id = candidate.known"
                              " JOIN shard.measure AS their_measure ON their_measure.run_id = theirs.run_id"
                              " JOIN main.measure AS our_measure ON our_measure.run_id = ours.run_id"
                              " WHERE {} ORDER BY theirs.run_id LIMIT 1",
                              fmt::join(differences, " OR ")));
    if (!statement.executeStep()) return;
    throw InputError({.file = from, .line = 0, .key = "run", .value = statement.getColumn(0).getString()},
                     fmt::format("({}) has another result than run {} of the same scenario here",
                                 statement.getColumn(1).getString(), statement.getColumn(2).getInt64()),
                     "find out which of the two is right and leave the other out");
}

/// The latest run of each scenario of the shard, with the run that is here already.
void list_candidates(Database& database) {
    database.exec(
        "CREATE TEMP TABLE candidate AS"
        " SELECT theirs.old, theirs.scenario_id, (SELECT max(run_id) FROM main.run AS ours"
        " WHERE ours.scenario_id = theirs.scenario_id AND ours.status <> 'interrupted') AS known"
        " FROM (SELECT max(run.run_id) AS old, scenario_id_map.new AS scenario_id FROM shard.run"
        " JOIN temp.scenario_id_map ON scenario_id_map.old = run.scenario_id"
        " WHERE run.status <> 'interrupted' GROUP BY run.scenario_id) AS theirs ORDER BY theirs.old");
}

void add_runs(Database& database) {
    const Names columns = without(columns_of("run"), "run_id");
    database.exec("CREATE TEMP TABLE run_id_map (old INTEGER PRIMARY KEY, new INTEGER)");
    Statement insert(database,
                     fmt::format("INSERT INTO main.run ({}) SELECT {} FROM shard.run WHERE run_id = ?",
                                 fmt::join(columns, ", "),
                                 fmt::join(selected("run", columns, {"scenario_id", "line_id"}), ", ")));
    Statement note(database, "INSERT INTO temp.run_id_map (old, new) VALUES (?, ?)");
    Statement candidates(database, "SELECT old FROM temp.candidate WHERE known IS NULL ORDER BY old");
    while (candidates.executeStep()) {
        const long old = candidates.getColumn(0).getInt64();
        insert.bind(1, old);
        insert.exec();
        insert.reset();
        SQLite::bind(note, old, static_cast<long>(database.getLastInsertRowid()));
        note.exec();
        note.reset();
    }
    for (const auto& [table, own] : known_tables()) {
        if (table == "run" || table == "ladder_run" || !known_table(table).has("run_id")) continue;
        database.exec(
            fmt::format("INSERT INTO main.{0} ({1}) SELECT {2} FROM shard.{0}"
                        " WHERE run_id IN (SELECT old FROM temp.run_id_map)",
                        table, fmt::join(own, ", "), fmt::join(selected(table, own, {"run_id"}), ", ")));
    }
}

void merge_studies(Database& database, const std::string& from) {
    Statement clash(database,
                    "SELECT theirs.name FROM shard.study AS theirs JOIN main.study AS ours USING (name)"
                    " WHERE theirs.text <> ours.text LIMIT 1");
    if (clash.executeStep())
        throw InputError(
            {.file = from, .line = 0, .key = "study", .value = clash.getColumn(0).getString()},
            "asks something else than the study of that name here (its file, or a file that it names, was "
            "another)",
            "merge parts of one study");
    database.exec(
        "INSERT OR IGNORE INTO main.study (name, text) SELECT name, text FROM shard.study ORDER BY study_id;"
        "INSERT OR REPLACE INTO main.study_scenario (study_id, scenario_index, scenario_hash, inputs, "
        "refusal)"
        " SELECT ours.study_id, part.scenario_index, part.scenario_hash, part.inputs, part.refusal"
        " FROM shard.study_scenario AS part JOIN shard.study AS theirs ON theirs.study_id = part.study_id"
        " JOIN main.study AS ours ON ours.name = theirs.name");
}

void merge_refused_sections(Database& database) {
    const Names columns = columns_of("refused_section");
    database.exec(fmt::format(
        "INSERT OR REPLACE INTO main.refused_section ({}) SELECT {} FROM shard.refused_section",
        fmt::join(columns, ", "), fmt::join(selected("refused_section", columns, {"line_id"}), ", ")));
}

long count(Database& database, const std::string& what) {
    return database.execAndGet("SELECT count(*) FROM " + what).getInt64();
}

}  // namespace

MergeCounts merge_attached(Database& database, const std::string& from) {
    merge_hashed(database, {"section", "section_id", "section_hash", {}});
    merge_parts(database, "section_point", "section_id");
    merge_hashed(database, {"source", "source_id", "source_hash", {"section_id"}});
    merge_parts(database, "source_point", "source_id");
    merge_hashed(database, {"scenario", "scenario_id", "scenario_hash", {"source_id"}});
    merge_hashed(database, {"map_line", "line_id", "line_hash", {}});
    merge_parts(database, "map_line_point", "line_id");
    merge_parts(database, "map_line_attribute", "line_id");
    list_candidates(database);
    refuse_conflicts(database, from);
    add_runs(database);
    merge_studies(database, from);
    merge_refused_sections(database);
    const MergeCounts counts{.runs_added = count(database, "temp.run_id_map"),
                             .runs_known = count(database, "temp.candidate WHERE known IS NOT NULL"),
                             .interrupted = count(database, "shard.run WHERE status = 'interrupted'"),
                             .studies = count(database, "shard.study")};
    for (const char* table :
         {"section_id_map", "source_id_map", "scenario_id_map", "line_id_map", "candidate", "run_id_map"})
        database.exec(fmt::format("DROP TABLE temp.{}", table));
    return counts;
}

}  // namespace runout
