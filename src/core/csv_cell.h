#pragma once

#include <string>

namespace runout {

/// Text as one cell of a CSV (RFC 4180): quoted where it would break the row up, and as printable() shows it.
/// A text that a spreadsheet would take for a formula (it begins with = + - @) and that is no number gets an
/// apostrophe before it, which keeps it text.
std::string csv_cell(const std::string& text);

}  // namespace runout
