#include "store/schema_comments.h"

#include <regex>
#include <sstream>

#include "store/schema_sql.h"

namespace runout {

SchemaComments schema_comments(const std::string& sql) {
    static const std::regex table_line(R"(CREATE TABLE (\w+) \(.*)");
    static const std::regex comment_line(R"(-- ?(.*))");
    static const std::regex column_line(R"(\s+(\w+) +(TEXT|REAL|INTEGER|BLOB)[^-]*(-- +(.*))?)");
    SchemaComments comments;
    std::istringstream lines(sql);
    std::string table, above;
    std::smatch found;
    for (std::string line; std::getline(lines, line);) {
        if (std::regex_match(line, found, comment_line)) {
            if (!above.empty()) above += ' ';
            above += found[1].str();
        } else if (std::regex_match(line, found, table_line)) {
            table = found[1];
            comments.tables[table] = above;
        } else if (!table.empty() && std::regex_match(line, found, column_line)) {
            comments.columns[table + "." + found[1].str()] = found[4];
        } else {
            if (line.starts_with(")")) table.clear();
            above.clear();
        }
    }
    return comments;
}

const SchemaComments& schema_comments() {
    static const SchemaComments comments = schema_comments(std::string(schema_sql));
    return comments;
}

}  // namespace runout
