#include "report/map/map_styles.h"

#include <fmt/format.h>

#include "report/chart/svg_text.h"

namespace runout {
namespace {

std::string rgba(const Colour& colour) {
    return fmt::format("{},{},{},{}", colour.red, colour.green, colour.blue, colour.alpha);
}

std::string option(const std::string& name, const std::string& value) {
    return fmt::format(R"(<Option type="QString" name="{}" value="{}"/>)", name, xml_text(value));
}

std::string symbol(const std::string& type, int number, const std::string& layer,
                   const std::string& options) {
    return fmt::format(
        R"(<symbol type="{}" name="{}" alpha="1" clip_to_extent="1" force_rhr="0"><layer class="{}" enabled="1" pass="0" locked="0"><Option type="Map">{}</Option></layer></symbol>)",
        type, number, layer, options);
}

std::string line_symbol(int number, const Colour& colour, double width_mm) {
    return symbol("line", number, "SimpleLine",
                  option("line_color", rgba(colour)) + option("line_width", fmt::format("{}", width_mm)) +
                      option("line_width_unit", "MM") + option("capstyle", "flat") +
                      option("joinstyle", "round"));
}

std::string document(const std::string& renderer, const std::string& labeling) {
    return fmt::format(
        R"(<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'><qgis version="3.22" styleCategories="Symbology|Labeling" labelsEnabled="{}">{}{}</qgis>)",
        labeling.empty() ? 0 : 1, renderer, labeling);
}

std::string single(const std::string& one_symbol) {
    return fmt::format(
        R"(<renderer-v2 type="singleSymbol" symbollevels="0"><symbols>{}</symbols></renderer-v2>)",
        one_symbol);
}

std::string labels(const std::string& expression) {
    if (expression.empty()) return {};
    return fmt::format(
        R"(<labeling type="simple"><settings><text-style fieldName="{}" isExpression="1" fontSize="8" fontSizeUnit="Point" textColor="40,40,40,255"><text-buffer bufferDraw="1" bufferSize="0.8" bufferSizeUnits="MM" bufferColor="255,255,255,255"/></text-style><placement placement="6" dist="1.5" distUnits="MM"/><rendering obstacle="1" displayAll="0"/></settings></labeling>)",
        xml_text(expression));
}

}  // namespace

std::string point_style(const Colour& colour, double size_mm, const std::string& label_expression) {
    return document(
        single(symbol("marker", 0, "SimpleMarker",
                      option("name", "circle") + option("color", rgba(colour)) +
                          option("outline_color", "255,255,255,255") + option("outline_width", "0.2") +
                          option("size", fmt::format("{}", size_mm)) + option("size_unit", "MM"))),
        labels(label_expression));
}

std::string line_style(const Colour& colour, double width_mm) {
    return document(single(line_symbol(0, colour, width_mm)), "");
}

std::string polygon_style(const Colour& fill, const Colour& outline) {
    return document(single(symbol("fill", 0, "SimpleFill",
                                  option("style", "solid") + option("color", rgba(fill)) +
                                      option("outline_color", rgba(outline)) +
                                      option("outline_width", "0.3") + option("outline_style", "solid"))),
                    "");
}

std::string graduated_line_style(const std::string& field, const std::vector<ColourClass>& classes,
                                 double width_mm) {
    std::string ranges;
    std::string symbols;
    for (std::size_t i = 0; i < classes.size(); ++i) {
        const ColourClass& item = classes[i];
        ranges += fmt::format(R"(<range lower="{}" upper="{}" symbol="{}" label="{}" render="true"/>)",
                              item.low, item.high, i, xml_text(item.label));
        symbols += line_symbol(static_cast<int>(i), item.colour, width_mm);
    }
    return document(
        fmt::format(
            R"(<renderer-v2 type="graduatedSymbol" attr="{}" graduatedMethod="GraduatedColor" symbollevels="0"><ranges>{}</ranges><symbols>{}</symbols></renderer-v2>)",
            xml_text(field), ranges, symbols),
        "");
}

}  // namespace runout
