#pragma once

#include <string>

namespace runout {

/// A text in quotes, as TOML reads it back.
std::string toml_string(const std::string& text);

/// A sentence as lines of a comment, each no longer than a screen is wide.
std::string toml_comment(const std::string& sentence);

}  // namespace runout
