#include "report/chart/svg_text.h"

#include <fmt/format.h>

#include <sstream>

#include "core/printable.h"

namespace runout {
namespace {

constexpr double letter_width = 0.6;  // of the font size; DejaVu Sans, a wide font, has 0.58

std::string xml_letter(char letter) {
    switch (letter) {
        case '&':
            return "&amp;";
        case '<':
            return "&lt;";
        case '>':
            return "&gt;";
        case '"':
            return "&quot;";
        case '\'':
            return "&apos;";
        default:
            return {letter};
    }
}

}  // namespace

std::string xml_text(const std::string& text) {
    std::string line = text;
    for (char& letter : line)
        if (static_cast<unsigned char>(letter) < 0x20) letter = ' ';
    std::string escaped;
    for (const char letter : printable(line)) escaped += xml_letter(letter);
    return escaped;
}

double text_width(const std::string& text, double font_size) {
    double width = 0.0;
    for (const char letter : text) {
        const auto byte = static_cast<unsigned char>(letter);
        if ((byte & 0xC0U) == 0x80U) continue;  // inside a character of UTF-8
        width += font_size * (byte >= 0xE3 ? 1.0 : letter_width);
    }
    return width;
}

std::vector<std::string> wrapped(const std::string& text, double font_size, double width) {
    std::istringstream words(text);
    std::vector<std::string> lines(1);
    for (std::string word; words >> word;) {
        std::string& line = lines.back();
        if (line.empty())
            line = word;
        else if (text_width(line + " " + word, font_size) <= width)
            line += " " + word;
        else
            lines.push_back(word);
    }
    return lines;
}

std::string pixels(double value) {
    return fmt::format("{:.4g}", value);
}

std::string svg_label(double x, double y, const std::string& text, const std::string& attributes) {
    return fmt::format("<text x=\"{}\" y=\"{}\"{}>{}</text>\n", pixels(x), pixels(y), attributes,
                       xml_text(text));
}

}  // namespace runout
