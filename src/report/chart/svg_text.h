#pragma once

#include <string>
#include <vector>

namespace runout {

/// Text as XML content or attribute value. Characters that XML 1.0 forbids become spaces.
std::string xml_text(const std::string& text);

/// Width in pixels, on the safe side: which font the reader has is not known.
double text_width(const std::string& text, double font_size);

/// Lines of whole words that are not wider than `width` pixels, unless a single word is. At least one line.
std::vector<std::string> wrapped(const std::string& text, double font_size, double width);

/// A coordinate in pixels.
std::string pixels(double value);

/// A text element; `attributes` with a leading space.
std::string svg_label(double x, double y, const std::string& text, const std::string& attributes);

}  // namespace runout
