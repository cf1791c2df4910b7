#pragma once

#include <toml++/toml.h>

#include <optional>
#include <string>

#include "core/input_error.h"

namespace runout {

// What is common to all files that a user writes in TOML.

/// The text of such a file. `valid` says what to give where there is none. Throws InputError as
/// read_text_file, and for one longer than any case or study is.
std::string read_toml_text(const std::string& path, const std::string& valid);

/// `text` as TOML; `path` is named in errors. Throws InputError: text that does not parse, or that is nested
/// deeper than any case is.
toml::table parse_toml(const std::string& text, const std::string& path);

/// A number, written as a whole one or not, rounded to a double; none for anything else.
std::optional<double> number_in(const toml::node& node);

}  // namespace runout
