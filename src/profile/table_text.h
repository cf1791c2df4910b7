#pragma once

#include <string>

namespace runout {

/// The text of a table, whatever program wrote it, as UTF-8: from UTF-8 or UTF-16 with or without a
/// byte-order mark, else from Windows-1252. Line ends (CRLF, CR) become LF, typographic minus signs `-`,
/// apostrophes `'`, and every non-breaking or thin blank U+00A0. Throws InputError: no text (a workbook, a
/// picture, a zero byte), or UTF-16 cut short; `path` is for the message.
std::string table_text(std::string bytes, const std::string& path);

}  // namespace runout
