#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/ranges.h>

#include <span>
#include <string>
#include <vector>

#include "store/columns.h"
#include "store/real_value.h"

namespace runout {

// Rows of the database from the lists of columns, and back.

/// "INSERT INTO table (a, b) VALUES (?, ?)"
inline std::string insert_sql(const char* table, const std::vector<std::string>& columns) {
    const std::vector<std::string> places(columns.size(), "?");
    return fmt::format("INSERT INTO {} ({}) VALUES ({})", table, fmt::join(columns, ", "),
                       fmt::join(places, ", "));
}

template <class Columns>
void append_names(std::vector<std::string>& names, const Columns& columns) {
    for (const auto& column : columns) names.emplace_back(column.name);
}

/// Binds the numbers of a row behind what was bound last, at `place`.
template <class Row>
void bind_numbers(SQLite::Statement& statement, int& place, const Row& row,
                  std::span<const RealColumn<Row>> columns) {
    for (const RealColumn<Row>& column : columns) statement.bind(++place, row.*column.value);
}

/// Reads them from the column `place` on, which is then the one behind them.
template <class Row>
void read_numbers(const SQLite::Statement& statement, int& place, Row& row,
                  std::span<const RealColumn<Row>> columns) {
    for (const RealColumn<Row>& column : columns)
        row.*column.value = real_value(statement.getColumn(place++));
}

}  // namespace runout
