#include "report/chart/svg_chart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <regex>
#include <set>

#include "report/chart/axis.h"

namespace runout {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// First group of every match.
std::vector<std::string> all(const std::string& text, const std::string& pattern) {
    const std::regex regex(pattern);
    std::vector<std::string> found;
    for (std::sregex_iterator i(text.begin(), text.end(), regex), end; i != end; ++i)
        found.push_back((*i)[1]);
    return found;
}

std::vector<std::string> curve_paths(const std::string& svg) {
    return all(svg, "<path class=\"curve\"[^>]* d=\"([^\"]*)\"");
}

/// The points of a path of M and L alone.
std::vector<Vec2> points_of(const std::string& path) {
    std::vector<Vec2> points;
    const std::regex regex("[ML]([-0-9.e]+) ([-0-9.e]+)");
    for (std::sregex_iterator i(path.begin(), path.end(), regex), end; i != end; ++i)
        points.emplace_back(std::stod((*i)[1]), std::stod((*i)[2]));
    return points;
}

double view_height(const std::string& svg) {
    return std::stod(all(svg, "viewBox=\"0 0 720 ([0-9.]+)\"").at(0));
}

Figure figure_of(std::vector<Curve> curves) {
    return {.name = "figure",
            .title = "Title",
            .x_label = "x, m",
            .y_label = "y, m",
            .curves = std::move(curves)};
}

AxisRange range(double low, double high) {
    AxisRange result;
    result.include(low);
    result.include(high);
    return result;
}

using Numbers = std::vector<double>;
using Texts = std::vector<std::string>;

TEST(SvgChart, BothAxesMayBeLogarithmic) {
    Figure figure = figure_of({{.label = "a", .points = {{0.01, 100}, {0.1, 10}, {1, 1}, {10, 0}}}});
    figure.logarithmic_x = true;
    figure.logarithmic_y = true;
    const auto points = points_of(curve_paths(svg_chart(figure)).at(0));
    ASSERT_EQ(points.size(), 3u) << "zero has no logarithm";
    EXPECT_NEAR(points[1].x() - points[0].x(), points[2].x() - points[1].x(), 0.2);
    EXPECT_NEAR(points[1].y() - points[0].y(), points[2].y() - points[1].y(), 0.2);
    EXPECT_GT(points[1].y(), points[0].y()) << "less is lower";
}

// ---- Axes

TEST(Axis, TicksAreOneTwoFiveAroundTheData) {
    const Axis axis = linear_axis(range(0.3, 9.1), 5);
    EXPECT_EQ(axis.ticks, (Numbers{0, 2, 4, 6, 8, 10}));
    EXPECT_EQ(axis.low, 0.0);
    EXPECT_EQ(axis.high, 10.0);
    EXPECT_EQ(tick_labels(linear_axis(range(-0.1, 0.2), 3)), (Texts{"-0.1", "0", "0.1", "0.2"}));
    EXPECT_EQ(tick_labels(linear_axis(range(0, 12000), 3)), (Texts{"0", "5000", "10000", "15000"}));
}

TEST(Axis, GivenEndsKeepTicksInside) {
    const Axis axis = fixed_axis(range(-0.3, 1.1), 3);
    EXPECT_EQ(axis.low, -0.3);
    EXPECT_EQ(axis.high, 1.1);
    EXPECT_EQ(axis.ticks, (Numbers{0, 0.5, 1}));
    EXPECT_EQ(fixed_axis(range(-4, 4), 1).ticks, (Numbers{-4, -2, 0, 2, 4})) << "one number tells no scale";
}

TEST(Axis, LabelsTellNeighboursApart) {
    const Texts labels = tick_labels(linear_axis(range(1000000.1, 1000000.4), 4));
    EXPECT_EQ(std::set<std::string>(labels.begin(), labels.end()).size(), labels.size());
    EXPECT_TRUE(has(labels.at(1), "1000000.")) << labels.at(1);
}

TEST(Axis, LogarithmicHasOneTwoFiveOfEveryDecade) {
    const Axis axis = logarithmic_axis(range(30, 1500), 10);
    EXPECT_EQ(tick_labels(axis), (Texts{"20", "50", "100", "200", "500", "1000", "2000"}));
    EXPECT_NEAR(axis.position(200), 0.5, 1e-12);
}

TEST(Axis, LogarithmicKeepsDecadesAloneWhereThereIsNoRoom) {
    EXPECT_EQ(tick_labels(logarithmic_axis(range(1e-3, 1e3), 8)),
              (Texts{"0.001", "0.01", "0.1", "1", "10", "100", "1000"}));
    EXPECT_LE(logarithmic_axis(range(1e-30, 1e30), 8).ticks.size(), 8u);
}

TEST(Axis, ASingleValueOrNoneSpansALength) {
    for (const Axis& axis : {linear_axis(range(3, 3), 5), linear_axis(range(0, 0), 5), linear_axis({}, 5),
                             linear_axis(range(-2e9, -2e9), 5), logarithmic_axis(range(10, 10), 5),
                             logarithmic_axis(range(12, 12), 5), logarithmic_axis({}, 5)}) {
        EXPECT_LT(axis.low, axis.high);
        EXPECT_GE(axis.ticks.size(), 2u);
        EXPECT_LE(axis.ticks.size(), 20u);
    }
    EXPECT_NEAR(logarithmic_axis(range(10, 10), 5).position(10), 1.0, 1e-12);
}

// ---- Charts

TEST(SvgChart, EscapesEveryText) {
    Figure figure = figure_of({{"a < b", Curve::Style::line, {{0, 0}, {1, 1}}}});
    figure.title = "\"Q\" & A\x01";
    figure.x_label = "<x>";
    figure.y_label = "it's";
    const std::string svg = svg_chart(figure);
    for (const char* text :
         {">a &lt; b<", ">&quot;Q&quot; &amp; A <", ">&lt;x&gt;</text>", ">it&apos;s</text>"})
        EXPECT_TRUE(has(svg, text)) << text;
    EXPECT_FALSE(has(svg, "<x>"));
    EXPECT_FALSE(has(svg, "\x01"));
}

TEST(SvgChart, PartsTheLineAtPointsThatAreNotNumbers) {
    const std::vector<Vec2> points{{0, 0}, {1, 1}, {nan, 2}, {3, 3}, {4, 4}, {5, HUGE_VAL}, {6, 1}};
    const std::string svg = svg_chart(figure_of({{"c", Curve::Style::line, points}}));
    const std::string path = curve_paths(svg).at(0);
    EXPECT_EQ(std::ranges::count(path, 'M'), 3);
    EXPECT_EQ(std::ranges::count(path, 'L'), 2);
    EXPECT_TRUE(path.ends_with("h0")) << "a point alone is a dot: " << path;
    EXPECT_FALSE(has(svg, "nan"));
    EXPECT_FALSE(has(svg, "inf"));
}

TEST(SvgChart, LeavesOutMarkersThatAreNotNumbers) {
    const std::vector<Vec2> points{{0, 0}, {nan, 1}, {2, 2}};
    const std::string svg = svg_chart(figure_of({{"", Curve::Style::markers, points}}));
    EXPECT_EQ(all(svg, "<(circle)").size(), 2u);
    EXPECT_FALSE(has(svg, "nan"));
}

TEST(SvgChart, DrawsNothingOfAnEmptyCurve) {
    for (const Figure& figure : {figure_of({}), figure_of({{"c", Curve::Style::line, {}}}),
                                 figure_of({{"c", Curve::Style::markers, {{nan, nan}}}})}) {
        const std::string svg = svg_chart(figure);
        EXPECT_TRUE(svg.ends_with("</svg>\n"));
        EXPECT_TRUE(curve_paths(svg).empty());
        EXPECT_FALSE(has(svg, "nan"));
    }
}

TEST(SvgChart, ASinglePointIsWithinThePlot) {
    for (const bool equal : {false, true}) {
        Figure figure = figure_of({{"c", Curve::Style::line, {{3, 0}}}});
        figure.equal_scales = equal;
        const Vec2 at = points_of(curve_paths(svg_chart(figure)).at(0)).at(0);
        EXPECT_GT(at.x(), 50.0);
        EXPECT_LT(at.x(), 700.0);
        EXPECT_GT(at.y(), 40.0);
        EXPECT_LT(at.y(), view_height(svg_chart(figure)) - 60.0);
    }
}

/// Pixels for a metre along x and along y, of a right angle of 1 m by 1 m that is drawn in a range.
Vec2 scale_of(double width, double height) {
    Figure figure = figure_of({{"range", Curve::Style::line, {{0, 0}, {width, height}}},
                               {"angle", Curve::Style::line, {{0, 0}, {1, 0}, {1, 1}}}});
    figure.equal_scales = true;
    const std::string svg = svg_chart(figure);
    EXPECT_LT(view_height(svg), 650.0);
    const std::vector<Vec2> drawn = points_of(curve_paths(svg).at(1));
    EXPECT_EQ(drawn.size(), 3u);
    return {(drawn[1] - drawn[0]).norm(), (drawn[2] - drawn[1]).norm()};
}

TEST(SvgChart, AMetreIsEquallyLongOnBothAxes) {
    for (const Vec2& size : {Vec2(10, 4), Vec2(40, 1), Vec2(4, 10), Vec2(1, 40)}) {
        const Vec2 scale = scale_of(size.x(), size.y());
        EXPECT_NEAR(scale.x(), scale.y(), 0.15)
            << size.x() << " x " << size.y();  // coordinates end at a tenth of a pixel
        EXPECT_GT(scale.x(), 8.0) << "the plot is used";
    }
}

TEST(SvgChart, AFlatProfileIsAFlatPicture) {
    Figure figure = figure_of({{"c", Curve::Style::line, {{0, 0}, {40, 1}}}});
    const double height = view_height(svg_chart(figure));
    figure.equal_scales = true;
    EXPECT_LT(view_height(svg_chart(figure)), 0.6 * height);
}

TEST(SvgChart, WithoutEqualScalesFillsThePlot) {
    const std::string svg = svg_chart(figure_of({{"c", Curve::Style::line, {{0, 0}, {100, 1}}}}));
    const std::vector<Vec2> ends = points_of(curve_paths(svg).at(0));
    EXPECT_GT(ends[1].x() - ends[0].x(), 500.0);
    EXPECT_GT(ends[0].y() - ends[1].y(), 300.0);
}

TEST(SvgChart, LogarithmicSpreadsDecadesEvenly) {
    Figure figure = figure_of({{"c", Curve::Style::line, {{0, 5}, {1, 0}, {10, 1}, {100, 2}}}});
    figure.logarithmic_x = true;
    figure.equal_scales = true;
    const std::vector<Vec2> drawn = points_of(curve_paths(svg_chart(figure)).at(0));
    ASSERT_EQ(drawn.size(), 3u) << "zero has no logarithm";
    EXPECT_NEAR(drawn[1].x() - drawn[0].x(), drawn[2].x() - drawn[1].x(), 0.15);
    EXPECT_EQ(all(svg_chart(figure), "class=\"x-tick\"[^>]*>([^<]*)<"),
              (Texts{"1", "2", "5", "10", "20", "50", "100"}));
}

TEST(SvgChart, CurvesDifferWithoutColour) {
    using enum Curve::Style;
    const std::vector<Vec2> points{{0, 0}, {1, 1}};
    const std::string svg = svg_chart(
        figure_of({{"1", line, points}, {"2", line, points}, {"3", dashed, points}, {"4", dashed, points}}));
    std::set<std::string> strokes;
    for (const std::string& attributes : all(svg, "<path class=\"curve\"([^>]*)/>"))
        strokes.insert(std::regex_replace(attributes, std::regex(" (stroke|d)=\"[^\"]*\""), ""));
    EXPECT_EQ(strokes.size(), 4u);

    const std::string marked = svg_chart(figure_of({{"1", markers, points}, {"2", markers, points}}));
    EXPECT_EQ(all(marked, "<(circle)").size(), 3u) << "two in the plot, one in the legend";
}

TEST(SvgChart, LegendIsBelowThePlotWithinThePicture) {
    std::vector<Curve> curves;
    for (int i = 0; i < 9; ++i)
        curves.push_back({"curve number " + std::to_string(i), Curve::Style::line, {{0, 0}, {1, 1}}});
    curves.push_back({"", Curve::Style::line, {{0, 0}, {1, 1}}});
    curves.push_back({std::string(30, 'w') + " " + std::string(60, 'w'), Curve::Style::line, {}});
    const std::string svg = svg_chart(figure_of(curves));
    const double bottom = std::stod(all(svg, "y=\"([0-9.]+)\" class=\"x-tick\"").at(0));
    const Texts samples = all(svg, "<path class=\"sample\"[^>]* d=\"M[0-9.]+ ([0-9.]+)");
    ASSERT_EQ(samples.size(), 10u) << "a curve without a label has no place in the legend";
    for (const std::string& y : samples) {
        EXPECT_GT(std::stod(y), bottom + 20.0);
        EXPECT_LT(std::stod(y), view_height(svg) - 8.0);
    }
    const Texts labels = all(svg.substr(svg.find("class=\"legend\"")), "<text x=\"[0-9.]+\" y=\"([0-9.]+)\"");
    EXPECT_EQ(labels.size(), 11u);
    for (const std::string& y : labels) EXPECT_LT(std::stod(y), view_height(svg) - 6.0);
    EXPECT_TRUE(has(svg, ">" + std::string(60, 'w') + "<")) << "a long label has two lines";
}

TEST(SvgChart, NoTextIsSmallerThanTwelvePixels) {
    const std::string svg = svg_chart(figure_of({{"c", Curve::Style::line, {{0, 0}, {1, 1}}}}));
    const Texts sizes = all(svg, "font-size=\"([0-9.]+)\"");
    EXPECT_GE(sizes.size(), 4u);
    for (const std::string& size : sizes) EXPECT_GE(std::stod(size), 12.0);
}

}  // namespace
}  // namespace runout
