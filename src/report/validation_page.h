#pragma once

#include <span>
#include <string>

#include "validation/entry.h"

namespace runout {

/// The whole table as plain text for a terminal: case, quantity, measured, computed, deviation, accepted,
/// pass; then one line that counts.
std::string validation_table(std::span<const CaseReport> reports);

/// The validation page in Markdown: what is held against what, all tables, figures as links to
/// `<picture_folder>/<case>-<figure>.svg`. `command` is what made it.
std::string validation_page(std::span<const CaseReport> reports, const std::string& command,
                            const std::string& picture_folder);

}  // namespace runout
