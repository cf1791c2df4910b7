#pragma once

#include <string>

namespace runout {

/// `text` with a line at its end by which it is known as an unedited output of this program: the SHA-256 of
/// all before it, in a comment of HTML, SVG, XML and Markdown (`path` ends with .md), or as a last member of
/// a JSON object. Other texts have no place for one and stay as they are.
std::string with_output_mark(const std::string& text, const std::string& path);

/// Whether the file is what with_output_mark made, byte for byte.
bool is_unedited_output(const std::string& path);

}  // namespace runout
