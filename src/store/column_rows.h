#pragma once

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/ranges.h>

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "store/columns.h"

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

/// SQLite stores a bound NaN as NULL and reads NULL as 0, so only the way back needs care.
inline double real(const SQLite::Column& column) {
    return column.isNull() ? std::numeric_limits<double>::quiet_NaN() : column.getDouble();
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
    for (const RealColumn<Row>& column : columns) row.*column.value = real(statement.getColumn(place++));
}

}  // namespace runout
