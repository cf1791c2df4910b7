#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "validation/entry.h"

namespace runout {

/// The whole table as plain text for a terminal: case, quantity, measured, computed, deviation, accepted,
/// verdict; then one line that counts.
std::string validation_table(std::span<const CaseReport> reports);

/// The validation page in Markdown, for the folder docs/: what is held against what, the entries outside
/// their band, all tables, figures as links to `<picture_folder>/<case>-<figure>.svg`. `command` is what made
/// it.
std::string validation_page(std::span<const CaseReport> reports, const std::string& command,
                            const std::string& picture_folder);

/// File name and SVG text of every picture the page links to.
std::vector<std::pair<std::string, std::string>> validation_pictures(std::span<const CaseReport> reports);

}  // namespace runout
