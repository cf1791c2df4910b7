#pragma once

#include <string>
#include <vector>

#include "core/figure.h"

namespace runout {

/// How a curve is told from the others: by colour, and without colour by dashes or the shape of its markers.
struct Pen {
    bool markers = false;
    bool area = false;
    std::string colour;
    std::string dashes;        ///< SVG stroke-dasharray; empty: solid
    std::size_t shape = 0;     ///< of the markers
    double marker_size = 4.0;  ///< half the width, px
};

/// One for each curve, in their order.
std::vector<Pen> pens_for(const std::vector<Curve>& curves);

/// Points in pixels, drawn. A point that is not finite parts the line; a point alone between gaps is a dot.
std::string drawn(const Pen& pen, const std::vector<Vec2>& points, const std::string& css_class);

}  // namespace runout
