#pragma once

#include <map>
#include <string>

namespace runout {

/// What db/schema.sql says in its comments, so that reports need not say it a second time.
struct SchemaComments {
    std::map<std::string, std::string> tables;   ///< the paragraph above each CREATE TABLE
    std::map<std::string, std::string> columns;  ///< the comment beside each column, by "table.column"
};

/// Reads the comments of a script laid out as db/schema.sql is: a column a line, its comment behind it.
SchemaComments schema_comments(const std::string& sql);

/// Those of the format that this program writes.
const SchemaComments& schema_comments();

}  // namespace runout
