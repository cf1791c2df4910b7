#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace runout {

// A name may hold anything: what moves a cursor, colours a terminal, forges the next row of a table or turns
// the reading direction round. These are control characters (C0, DEL, C1), line and paragraph separators,
// marks of direction, and bytes that are no UTF-8.

// Letters of no width are among them, but the two that join and part letters of Persian and Indian names.

/// Whether every byte is part of a character.
bool is_utf8(std::string_view text);

/// `text` as one line: each such byte as \xNN.
std::string printable(std::string_view text);

/// The same for a text of many lines, whose newlines stay.
std::string printable_lines(std::string_view text);

/// The same for a JSON text: \uNNNN, so that it stays the same value; what is no UTF-8 becomes U+FFFD.
std::string printable_json(std::string_view json);

/// `name` as one part of a path: neither a folder nor hidden nor an option, without what file systems of
/// other machines refuse, and at most 100 bytes long; what cannot stand becomes "_".
std::string file_name_part(std::string_view name);

/// The same for names whose files lie in one folder: no two are equal, on file systems that do not tell
/// capitals from small letters either. The later of two gets a number.
std::vector<std::string> distinct_file_names(const std::vector<std::string>& names);

}  // namespace runout
