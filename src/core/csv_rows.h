#pragma once

#include <string>
#include <vector>

#include "core/input_error.h"

namespace runout {

/// A line that says something, with its number in the file.
struct CsvRow {
    int line = 0;
    std::vector<std::string> fields;
};

/// Lines of a CSV file of this program's own form: `#` starts a comment; blank lines, a byte-order mark, CRLF
/// and quotes are accepted. Throws InputError as read_text_file; `valid` says what to give instead.
std::vector<CsvRow> read_csv_rows(const std::string& path, const std::string& valid);

/// The number written in `place.value`, with a point as decimal mark whatever the locale says. Throws
/// InputError: empty, not a number, not finite.
double csv_number(const InputPlace& place, const std::string& valid);

}  // namespace runout
