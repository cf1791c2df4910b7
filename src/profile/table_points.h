#pragma once

#include <string>

#include "profile/read_section_table.h"
#include "profile/section_points.h"
#include "profile/table_layout.h"
#include "profile/table_rows.h"

namespace runout {

/// A table of which the columns are known.
struct TableReading {
    const TableRows& table;
    Separator separator;
    const TableLayout& layout;
    const TableOptions& options;
    const std::string& path;
};

/// The points of a table whose columns are known. Throws InputError as read_section_table.
SectionPoints table_points(const TableReading& reading);

}  // namespace runout
