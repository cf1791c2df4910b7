#include "store/refused_rows.h"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/VariadicBind.h>

#include "store/run_places.h"

namespace runout {
namespace {

using SQLite::Database;
using SQLite::Statement;

void strike_off(Database& database, const std::string& origin, long feature_id) {
    Statement statement(database, "DELETE FROM refused_section WHERE origin = ? AND feature_id = ?");
    SQLite::bind(statement, origin, feature_id);
    statement.exec();
}

}  // namespace

void set_sections(Database& database, const SectionsTaken& sections) {
    for (const long feature_id : sections.taken) strike_off(database, sections.origin, feature_id);
    Statement statement(database,
                        "INSERT OR REPLACE INTO refused_section (origin, feature_id, name, reason, line_id)"
                        " VALUES (?, ?, ?, ?, ?)");
    for (const RefusedSection& refused : sections.refused) {
        SQLite::bind(statement, refused.origin, refused.feature_id, refused.name, refused.reason,
                     map_line_row(database, refused.line));
        statement.exec();
        statement.reset();
    }
}

std::vector<RefusedSection> select_refused_sections(Database& database) {
    Statement statement(database,
                        "SELECT origin, feature_id, name, reason, line_id FROM refused_section"
                        " ORDER BY origin, feature_id");
    std::vector<RefusedSection> sections;
    while (statement.executeStep())
        sections.push_back({statement.getColumn(0).getString(), statement.getColumn(1).getInt64(),
                            statement.getColumn(2).getString(), statement.getColumn(3).getString(),
                            select_map_line(database, statement.getColumn(4).getInt64())});
    return sections;
}

}  // namespace runout
