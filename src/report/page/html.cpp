#include "report/page/html.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "report/chart/svg_text.h"

namespace runout {
namespace {

struct UnitSuffix {
    const char* suffix;
    const char* unit;
};

// The longest that fits comes first.
constexpr std::array units = {
    UnitSuffix{"_kg_m3", "kg/m³"}, UnitSuffix{"_kg_m", "kg/m"}, UnitSuffix{"_j_m", "J/m"},
    UnitSuffix{"_m_s2", "m/s²"},   UnitSuffix{"_m_s", "m/s"},   UnitSuffix{"_m3", "m³"},
    UnitSuffix{"_m2", "m²"},       UnitSuffix{"_n_m", "N/m"},   UnitSuffix{"_kpa", "kPa"},
    UnitSuffix{"_pa", "Pa"},       UnitSuffix{"_deg", "deg"},   UnitSuffix{"_utc", "UTC"},
    UnitSuffix{"_m", "m"},         UnitSuffix{"_s", "s"},
};

// A few words, which a wide neighbour must not squeeze to a column of letters.
constexpr std::size_t longest_label = 32;

const char* class_of(const HtmlCell& cell) {
    if (cell.is_number) return " class=\"number\"";
    return !cell.html.empty() && cell.html.size() <= longest_label ? " class=\"label\"" : "";
}

std::string row_html(const HtmlRow& row) {
    std::string html = "<tr>";
    bool first = true;
    for (const HtmlCell& cell : row) {
        const char* tag = first && !cell.is_number ? "th scope=\"row\"" : "td";
        const std::string value =
            cell.value.empty() ? "" : fmt::format(" data-value=\"{}\"", html_text(cell.value));
        html += fmt::format("<{}{}{}>{}</{}>", tag, class_of(cell), value, cell.html,
                            std::string(tag).substr(0, 2));
        first = false;
    }
    return html + "</tr>\n";
}

}  // namespace

std::string html_text(const std::string& text) {
    return xml_text(text);
}

std::string html_number(double value) {
    return std::isfinite(value) ? fmt::format("{:.4g}", value) : "";
}

HtmlCell text_cell(const std::string& text) {
    return {html_text(text), {}, false};
}

HtmlCell number_cell(double value, int digits) {
    if (!std::isfinite(value)) return {"", {}, true};
    return {fmt::format("{:.{}g}", value, digits), fmt::format("{}", value), true};
}

HtmlCell value_cell(const StoredValue& value) {
    if (const auto* number = std::get_if<double>(&value)) return number_cell(*number, 6);
    if (const auto* count = std::get_if<long>(&value))
        return {std::to_string(*count), std::to_string(*count), true};
    if (const auto* text = std::get_if<std::string>(&value)) return text_cell(*text);
    return text_cell("-");
}

std::string html_table(const std::string& caption, const std::vector<std::string>& head,
                       const std::vector<HtmlRow>& rows) {
    std::string html =
        fmt::format("<div class=\"table\"><table>\n<caption>{}</caption>\n", html_text(caption));
    if (!head.empty()) {
        html += "<thead><tr>";
        for (const std::string& title : head)
            html += fmt::format("<th scope=\"col\">{}</th>", html_text(title));
        html += "</tr></thead>\n";
    }
    html += "<tbody>\n";
    for (const HtmlRow& row : rows) html += row_html(row);
    return html + "</tbody></table></div>\n";
}

std::string paragraph(const std::string& text) {
    return fmt::format("<p>{}</p>\n", html_text(text));
}

std::string bullet_list(const std::vector<std::string>& sentences) {
    std::string html = "<ul>\n";
    for (const std::string& sentence : sentences) html += fmt::format("<li>{}</li>\n", html_text(sentence));
    return html + "</ul>\n";
}

ColumnWords column_words(const std::string& column) {
    ColumnWords result{column, {}};
    for (const UnitSuffix& known : units)
        if (column.ends_with(known.suffix)) {
            result = {column.substr(0, column.size() - std::string(known.suffix).size()), known.unit};
            break;
        }
    for (char& letter : result.words)
        if (letter == '_') letter = ' ';
    if (result.words.starts_with("run out")) result.words.replace(0, 7, "run-out");
    return result;
}

}  // namespace runout
