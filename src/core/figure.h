#pragma once

#include <string>
#include <vector>

#include "core/geometry.h"

namespace runout {

/// Points of one curve of a figure, in its units.
struct Curve {
    enum class Style { line, dashed, markers, area };  ///< area: a closed polygon, filled
    std::string label{};
    Style style = Style::line;
    std::vector<Vec2> points{};
};

/// A chart, as numbers and words; report/chart draws it.
struct Figure {
    std::string name{};  ///< stem of its file, such as "profile"
    std::string title{};
    std::string x_label{}, y_label{};  ///< with units
    std::vector<Curve> curves{};
    bool equal_scales = false;  ///< one metre is as long on both axes
    bool logarithmic_x = false;
    bool logarithmic_y = false;
};

}  // namespace runout
