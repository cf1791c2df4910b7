#include "report/chart/svg_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "report/chart/axis.h"
#include "report/chart/curve_pen.h"
#include "report/chart/svg_text.h"

namespace runout {
namespace {

// All in pixels.
constexpr double page_width = 720.0, edge = 14.0, right_margin = 30.0;
constexpr double title_size = 16.0, label_size = 13.0, tick_size = 12.0, line_height = 17.0;
constexpr double widest_label = 0.25 * page_width;  // of the numbers along y
constexpr double plot_height = 360.0;
constexpr double least_width = 260.0, least_height = 110.0, greatest_height = 480.0;  // with equal scales
constexpr double x_tick_distance = 62.0, y_tick_distance = 40.0;
constexpr double sample_width = 46.0, sample_gap = 8.0, column_gap = 24.0;
constexpr double legend_width = page_width - 2.0 * edge, legend_row = 20.0;
constexpr double farthest = 1e100;  // beyond, sums of coordinates may not be numbers any more

/// The plotted area, and what it shows.
struct Plot {
    double left = 0.0, top = 0.0, width = 0.0, height = 0.0;
    Axis x, y;

    [[nodiscard]] double bottom() const { return top + height; }
    [[nodiscard]] double at_x(double value) const { return left + width * x.position(value); }
    [[nodiscard]] double at_y(double value) const { return bottom() - height * y.position(value); }
};

bool can_be_drawn(const Figure& figure, const Vec2& point) {
    if (!point.allFinite() || point.cwiseAbs().maxCoeff() > farthest) return false;
    if (figure.logarithmic_y && !(point.y() > 1.0 / farthest)) return false;
    return !figure.logarithmic_x || point.x() > 1.0 / farthest;
}

int ticks_in(double length, double distance) {
    return std::max(2, static_cast<int>(length / distance));
}

double widest(const std::vector<std::string>& labels) {
    double width = 0.0;
    for (const std::string& label : labels) width = std::max(width, text_width(label, tick_size));
    return width;
}

/// The plot with equal scales as large as it fits. Axes grow beyond the data where the picture would be a
/// strip.
void fit_equal_scales(Plot& plot, const AxisRange& x_data, const AxisRange& y_data) {
    constexpr double margin = 1.06;
    const AxisRange x = drawable(x_data), y = drawable(y_data);
    const double x_length = margin * x.length(), y_length = margin * y.length();
    const double scale = std::min(plot.width / x_length, greatest_height / y_length);
    plot.width = std::max(least_width, scale * x_length);
    plot.height = std::max(least_height, scale * y_length);
    plot.x = fixed_axis(x.widened_to(plot.width / scale), ticks_in(plot.width, x_tick_distance));
    plot.y = fixed_axis(y.widened_to(plot.height / scale), ticks_in(plot.height, y_tick_distance));
}

Plot plot_of(const Figure& figure, double top) {
    AxisRange x_data, y_data;
    for (const Curve& curve : figure.curves)
        for (const Vec2& point : curve.points)
            if (can_be_drawn(figure, point)) {
                x_data.include(point.x());
                y_data.include(point.y());
            }
    Plot plot;
    plot.top = top;
    plot.height = plot_height;
    const int y_ticks = ticks_in(plot.height, y_tick_distance);
    plot.y = figure.logarithmic_y ? logarithmic_axis(y_data, y_ticks) : linear_axis(y_data, y_ticks);
    const auto space_left = [&] {
        const std::size_t lines = wrapped(figure.y_label, label_size, plot.height).size();
        return edge + line_height * static_cast<double>(lines) +
               std::min(widest(tick_labels(plot.y)), widest_label) + 14.0;
    };
    plot.left = space_left();
    plot.width = page_width - plot.left - right_margin;
    if (figure.equal_scales && !figure.logarithmic_x && !figure.logarithmic_y) {
        fit_equal_scales(plot, x_data, y_data);
        plot.left = std::max(plot.left, space_left());
        plot.left += std::max(0.0, 0.5 * (page_width - right_margin - plot.left - plot.width));
    } else {
        const int count = ticks_in(plot.width, x_tick_distance);
        plot.x = figure.logarithmic_x ? logarithmic_axis(x_data, count) : linear_axis(x_data, count);
    }
    return plot;
}

std::string grid_line(double x1, double y1, double x2, double y2) {
    return fmt::format("<path d=\"M{} {}L{} {}\"/>\n", pixels(x1), pixels(y1), pixels(x2), pixels(y2));
}

std::string grid(const Plot& plot) {
    std::string text = "<g stroke=\"#ddd\" stroke-width=\"1\">\n";
    for (const double tick : plot.x.ticks)
        text += grid_line(plot.at_x(tick), plot.top, plot.at_x(tick), plot.bottom());
    for (const double tick : plot.y.ticks)
        text += grid_line(plot.left, plot.at_y(tick), plot.left + plot.width, plot.at_y(tick));
    return text +
           fmt::format(
               "</g>\n<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#444\"/>\n",
               pixels(plot.left), pixels(plot.top), pixels(plot.width), pixels(plot.height));
}

std::string tick_texts(const Plot& plot) {
    const std::vector<std::string> x_labels = tick_labels(plot.x), y_labels = tick_labels(plot.y);
    std::string text = fmt::format("<g font-size=\"{}\">\n", tick_size);
    for (std::size_t i = 0; i < x_labels.size(); ++i)
        text += svg_label(plot.at_x(plot.x.ticks[i]), plot.bottom() + 17.0, x_labels[i],
                          " class=\"x-tick\" text-anchor=\"middle\"");
    for (std::size_t i = 0; i < y_labels.size(); ++i)
        text += svg_label(plot.left - 7.0, plot.at_y(plot.y.ticks[i]) + 4.0, y_labels[i],
                          " class=\"y-tick\" text-anchor=\"end\"");
    return text + "</g>\n";
}

std::string axis_labels(const Figure& figure, const Plot& plot) {
    std::string text = fmt::format("<g font-size=\"{}\" text-anchor=\"middle\">\n", label_size);
    text += svg_label(plot.left + 0.5 * plot.width, plot.bottom() + 38.0, figure.x_label, "");
    const double middle = plot.top + 0.5 * plot.height;
    double x = plot.left - std::min(widest(tick_labels(plot.y)), widest_label) - 14.0;
    const std::vector<std::string> lines = wrapped(figure.y_label, label_size, plot.height);
    x -= line_height * static_cast<double>(lines.size() - 1);
    for (const std::string& line : lines) {
        text += svg_label(x, middle, line,
                          fmt::format(" transform=\"rotate(-90 {} {})\"", pixels(x), pixels(middle)));
        x += line_height;
    }
    return text + "</g>\n";
}

// Lines first: markers are measurements mostly, and must not vanish below a line.
std::string curves(const Figure& figure, const Plot& plot, const std::vector<Pen>& pens) {
    std::string text;
    for (const bool markers : {false, true})
        for (std::size_t i = 0; i < pens.size(); ++i) {
            if (pens[i].markers != markers) continue;
            std::vector<Vec2> points;
            for (const Vec2& point : figure.curves[i].points)
                points.emplace_back(can_be_drawn(figure, point)
                                        ? Vec2(plot.at_x(point.x()), plot.at_y(point.y()))
                                        : Vec2::Constant(std::numeric_limits<double>::quiet_NaN()));
            text += drawn(pens[i], points, "curve");
        }
    return text;
}

/// Line or marker as in the plot, and the label.
std::string legend_entry(Pen pen, const std::vector<std::string>& label, double x, double y) {
    std::vector<Vec2> sample{{x, y}, {x + sample_width, y}};
    if (pen.markers) sample = {{x + 0.5 * sample_width, y}};
    if (pen.area)
        sample = {{x, y - 6.0}, {x + sample_width, y - 6.0}, {x + sample_width, y + 6.0}, {x, y + 6.0}};
    pen.marker_size = std::max(pen.marker_size, 3.5);
    std::string text = drawn(pen, sample, "sample");
    for (const std::string& line : label) {
        text += svg_label(x + sample_width + sample_gap, y + 4.0, line, "");
        y += line_height;
    }
    return text;
}

double entry_width(const Curve& curve) {
    return sample_width + sample_gap + text_width(curve.label, label_size);
}

/// Width of the columns of the legend. A label too long for one of two columns gets lines of its own.
double column_width(const std::vector<Curve>& curves) {
    double width = 1.0;
    for (const Curve& curve : curves) {
        const double wanted = entry_width(curve);
        if (!curve.label.empty() && wanted <= 0.5 * (legend_width - column_gap))
            width = std::max(width, wanted);
    }
    return width;
}

/// Below the plot. Moves `y` to its lower end.
std::string legend(const Figure& figure, const std::vector<Pen>& pens, double& y) {
    const double column = column_width(figure.curves), end = edge + legend_width;
    std::string text = fmt::format("<g class=\"legend\" font-size=\"{}\">\n", label_size);
    double x = edge;
    for (std::size_t i = 0; i < pens.size(); ++i) {
        const Curve& curve = figure.curves[i];
        if (curve.label.empty()) continue;
        const double width = std::max(column, std::min(entry_width(curve), legend_width));
        if (x > edge && x + width > end) {
            x = edge;
            y += legend_row;
        }
        const std::vector<std::string> label =
            wrapped(curve.label, label_size, legend_width - sample_width - sample_gap);
        text += legend_entry(pens[i], label, x, y);
        y += line_height * static_cast<double>(label.size() - 1);
        x = width > column ? end : x + column + column_gap;
    }
    y += legend_row;
    return text + "</g>\n";
}

std::string heading(const std::vector<std::string>& lines) {
    std::string text =
        fmt::format("<g font-size=\"{}\" font-weight=\"bold\" text-anchor=\"middle\">\n", title_size);
    double y = edge + title_size;
    for (const std::string& line : lines) {
        text += svg_label(0.5 * page_width, y, line, "");
        y += 1.3 * title_size;
    }
    return text + "</g>\n";
}

}  // namespace

std::string svg_chart(const Figure& figure) {
    const std::vector<std::string> title = wrapped(figure.title, title_size, page_width - 2.0 * edge);
    const std::vector<Pen> pens = pens_for(figure.curves);
    const Plot plot = plot_of(figure, edge + 12.0 + 1.3 * title_size * static_cast<double>(title.size()));
    double y = plot.bottom() + 62.0;
    const std::string body = heading(title) + grid(plot) + tick_texts(plot) + axis_labels(figure, plot) +
                             curves(figure, plot, pens) + legend(figure, pens, y);
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
        "role=\"img\" font-family=\"sans-serif\" fill=\"#111\">\n<title>{2}</title>\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{3}</svg>\n",
        page_width, std::ceil(y), xml_text(figure.title), body);
}

}  // namespace runout
