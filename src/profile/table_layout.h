#pragma once

#include <optional>
#include <string>
#include <vector>

#include "profile/column_choice.h"
#include "profile/column_names.h"
#include "profile/table_rows.h"

namespace runout {

/// One of the two columns that make a section.
struct TableColumn {
    std::size_t index = 0;
    ColumnName name{};  ///< of the header; its unit may stand below it. Empty where there is no header
};

/// Where in a table the points stand.
struct TableLayout {
    TableColumn chainage{};
    TableColumn elevation{};
    std::size_t first_row = 0;         ///< of the points, in TableRows::rows()
    std::size_t header_cells = 0;      ///< a row may have no more; 0: no header
    bool by_name = false;              ///< the header's names chose the columns
    bool titles_mention_feet = false;  ///< a line above the points does
};

/// Finds header, columns and first point. Throws InputError: names that leave a choice, or names and numbers
/// that do not go together; `path` is for the message. None: no row of this table looks like a point.
std::optional<TableLayout> find_layout(const TableRows& table, Separator separator, const ColumnWish& wish,
                                       const std::string& path);

}  // namespace runout
