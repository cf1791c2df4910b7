#pragma once

#include <string>
#include <vector>

namespace runout {

/// Red, green, blue and opacity, each 0 to 255.
struct Colour {
    int red = 0;
    int green = 0;
    int blue = 0;
    int alpha = 255;
};

/// A class of a graduated style: values from `low` to `high`.
struct ColourClass {
    double low = 0;
    double high = 0;
    std::string label;
    Colour colour;
};

// QGIS layer styles (QML), read by QGIS 3. Sizes in millimetres on paper.

std::string point_style(const Colour& colour, double size_mm, const std::string& label_expression);
std::string line_style(const Colour& colour, double width_mm);
std::string polygon_style(const Colour& fill, const Colour& outline);
/// Lines coloured by a field.
std::string graduated_line_style(const std::string& field, const std::vector<ColourClass>& classes,
                                 double width_mm);

}  // namespace runout
