#include "report/page/page.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/version.h"
#include "report/page/html.h"
#include "report/page/page_files.h"

namespace runout {
namespace {

using Json = nlohmann::json;

// Positions of a pixel need no more; the page would be twice as large with every digit.
double short_number(double value) {
    return std::isfinite(value) ? std::stod(fmt::format("{:.6g}", value)) : value;
}

/// A point that is not finite is null: a gap in the line.
Json json_points(const std::vector<Vec2>& points) {
    Json list = Json::array();
    for (const Vec2& point : points)
        list.push_back(point.allFinite() ? Json{short_number(point.x()), short_number(point.y())} : Json());
    return list;
}

const char* style_word(Curve::Style style) {
    switch (style) {
        case Curve::Style::line:
            return "line";
        case Curve::Style::dashed:
            return "dashed";
        case Curve::Style::area:
            return "area";
        case Curve::Style::markers:
            break;
    }
    return "markers";
}

Json json_chart(const PageChart& chart) {
    Json curves = Json::array();
    for (const Curve& curve : chart.figure.curves)
        curves.push_back({{"label", curve.label},
                          {"style", style_word(curve.style)},
                          {"points", json_points(curve.points)}});
    return {{"title", chart.figure.title},        {"x", chart.figure.x_label},   {"y", chart.figure.y_label},
            {"logX", chart.figure.logarithmic_x}, {"logY", chart.logarithmic_y}, {"curves", curves}};
}

/// JSON that cannot end the element it stands in, whatever names are in it.
std::string inside_script(std::string json) {
    std::string safe;
    for (const char letter : json) safe += letter == '<' ? std::string("\\u003c") : std::string(1, letter);
    return safe;
}

std::string page_data(const std::vector<PageSection>& sections) {
    Json charts = Json::object();
    std::string animation = "null";
    for (const PageSection& section : sections) {
        for (const PageChart& chart : section.charts) charts[chart.id] = json_chart(chart);
        if (!section.animation.empty()) animation = section.animation;
    }
    const std::string text = charts.dump(-1, ' ', false, Json::error_handler_t::replace);
    return inside_script(fmt::format("{{\"charts\":{},\"animation\":{}}}", text, animation));
}

std::string contents(const std::vector<PageSection>& sections) {
    std::string html = "<nav aria-label=\"Contents\"><ul>\n";
    for (const PageSection& section : sections)
        if (!section.body.empty())
            html += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", section.id, html_text(section.title));
    return html + "</ul></nav>\n";
}

}  // namespace

std::string place_of(const PageChart& chart) {
    return fmt::format(
        "<figure class=\"chart\"><div class=\"plot\"><canvas id=\"chart-{0}\" role=\"img\" "
        "aria-label=\"Chart: {1}\"></canvas></div>\n<figcaption>{2}</figcaption>\n"
        "<details class=\"numbers\" data-chart=\"{0}\"><summary>Numbers of this chart</summary></details>"
        "</figure>\n",
        chart.id, html_text(chart.figure.title), html_text(chart.caption));
}

std::string html_page(const std::string& title, const std::string& subtitle,
                      const std::vector<PageSection>& sections) {
    std::string body;
    for (const PageSection& section : sections)
        if (!section.body.empty())
            body += fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n{}</section>\n", section.id,
                                html_text(section.title), section.body);
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta name=\"generator\" content=\"runout {}\">\n<link rel=\"icon\" href=\"data:,\">\n"
        "<title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n"
        "<header><h1>{}</h1>\n<p class=\"subtitle\">{}</p></header>\n{}<main>\n{}</main>\n"
        "<noscript><p>The charts and the animation need JavaScript; all numbers are in the "
        "tables.</p></noscript>\n"
        "<script type=\"application/json\" id=\"report-data\">{}</script>\n"
        "<script>{}</script>\n<script>\n{}</script>\n<script>\n{}</script>\n</body>\n</html>\n",
        html_text(program_version()), html_text(title), page_file::style(), html_text(title),
        html_text(subtitle), contents(sections), body, page_data(sections), page_file::charting_library(),
        page_file::charts(), page_file::animation());
}

}  // namespace runout
