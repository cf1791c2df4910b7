#include "report/chart/curve_pen.h"

#include <fmt/format.h>

#include <array>

#include "report/chart/svg_text.h"

namespace runout {
namespace {

// The palette of Okabe and Ito without its yellow, which is lost on white; neighbours differ in lightness.
constexpr std::array<const char*, 7> palette = {"#000000", "#D55E00", "#0072B2", "#E69F00",
                                                "#009E73", "#56B4E9", "#CC79A7"};
// Ends are round and as wide as the line, so that 0.1 is a dot.
constexpr std::array<const char*, 4> line_dashes = {"", "18 5", "18 5 0.1 5", "18 5 0.1 5 0.1 5"};
constexpr std::array<const char*, 4> dashed_dashes = {"5 5", "0.1 5", "5 5 0.1 5", "9 5 2 5"};

constexpr std::size_t shapes = 5;
constexpr std::size_t many_points = 60;  // from here on, markers of full size run into each other

std::string marker(const Pen& pen, const Vec2& at) {
    const std::string x = pixels(at.x()), y = pixels(at.y());
    const double a = pen.marker_size, b = 1.3 * a;
    const auto path = [&](const std::string& steps, bool filled) {
        return fmt::format("<path d=\"M{} {}{}\"{}/>\n", x, y, steps,
                           filled ? fmt::format(" fill=\"{}\"", pen.colour) : "");
    };
    switch (pen.shape) {
        case 0:
            return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", x, y, pixels(a));
        case 1:
            return path(fmt::format("m{0} {0}h{1}v{1}h{2}z", -a, 2 * a, -2 * a), true);
        case 2:
            return path(fmt::format("m0 {}l{} {}h{}z", -b, b, 1.8 * b, -2 * b), false);
        case 3:
            return path(fmt::format("m0 {}l{} {}l{} {}l{} {}z", -b, b, b, -b, b, -b, -b), true);
        default:
            return path(fmt::format("m{0} {0}l{1} {1}m0 {2}l{2} {1}", -a, 2 * a, -2 * a), false);
    }
}

std::string markers(const Pen& pen, const std::vector<Vec2>& points, const std::string& css_class) {
    std::string text = fmt::format("<g class=\"{}\" fill=\"#fff\" stroke=\"{}\" stroke-width=\"1.5\">\n",
                                   css_class, pen.colour);
    for (const Vec2& point : points)
        if (point.allFinite()) text += marker(pen, point);
    return text + "</g>\n";
}

/// "M1 2L3 4M5 6L7 8": every M begins after a gap.
std::string path_of(const std::vector<Vec2>& points) {
    std::string path, last;
    bool pen_down = false, alone = false;
    for (const Vec2& point : points) {
        if (!point.allFinite()) {
            if (alone) path += "h0";
            pen_down = alone = false;
            continue;
        }
        const std::string here = pixels(point.x()) + " " + pixels(point.y());
        if (pen_down && here == last) continue;  // closer than a tenth of a pixel
        path += (pen_down ? "L" : "M") + here;
        alone = !pen_down;
        pen_down = true;
        last = here;
    }
    return alone ? path + "h0" : path;
}

std::string line(const Pen& pen, const std::vector<Vec2>& points, const std::string& css_class) {
    const std::string path = path_of(points);
    if (path.empty()) return {};
    const std::string dashes = pen.dashes.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", pen.dashes);
    return fmt::format(
        "<path class=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\" stroke-linecap=\"round\" "
        "stroke-linejoin=\"round\"{} d=\"{}\"/>\n",
        css_class, pen.colour, dashes, path);
}

std::string area(const Pen& pen, const std::vector<Vec2>& points, const std::string& css_class) {
    return fmt::format("<path class=\"{}\" fill=\"{}\" fill-opacity=\"0.2\" stroke=\"none\" d=\"{}\"/>\n",
                       css_class, pen.colour, path_of(points));
}

}  // namespace

std::vector<Pen> pens_for(const std::vector<Curve>& curves) {
    std::vector<Pen> pens;
    std::size_t lines = 0, dashed = 0, marked = 0;
    for (const Curve& curve : curves) {
        Pen& pen = pens.emplace_back();
        pen.colour = palette[(pens.size() - 1) % palette.size()];
        pen.markers = curve.style == Curve::Style::markers;
        pen.area = curve.style == Curve::Style::area;
        if (pen.markers) pen.shape = marked++ % shapes;
        if (pen.markers && curve.points.size() > many_points) pen.marker_size = 2.5;
        if (curve.style == Curve::Style::line) pen.dashes = line_dashes[lines++ % line_dashes.size()];
        if (curve.style == Curve::Style::dashed) pen.dashes = dashed_dashes[dashed++ % dashed_dashes.size()];
    }
    return pens;
}

std::string drawn(const Pen& pen, const std::vector<Vec2>& points, const std::string& css_class) {
    if (pen.area) return area(pen, points, css_class);
    return pen.markers ? markers(pen, points, css_class) : line(pen, points, css_class);
}

}  // namespace runout
