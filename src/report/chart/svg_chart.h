#pragma once

#include <string>

#include "core/figure.h"

namespace runout {

/// The figure as a stand-alone SVG picture, 720 px wide, the same bytes for the same figure. Points that are
/// not finite are gaps, and so are points without a logarithm on a logarithmic axis, which goes before equal
/// scales. A curve without a label is drawn, but is not in the legend below the plot.
std::string svg_chart(const Figure& figure);

}  // namespace runout
