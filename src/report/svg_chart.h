#pragma once

#include <string>

#include "validation/entry.h"

namespace runout {

/// The figure as a stand-alone SVG picture.
std::string svg_chart(const Figure& figure);

}  // namespace runout
