#include "scene/toml_text.h"

#include <fmt/format.h>

#include <sstream>

namespace runout {
namespace {

constexpr std::size_t widest_comment = 110;

}  // namespace

std::string toml_string(const std::string& text) {
    std::string quoted(1, '"');
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\')
            quoted.append({'\\', c});
        else if (byte < 0x20 || byte == 0x7F)
            quoted += fmt::format("\\u{:04X}", byte);
        else
            quoted += c;
    }
    quoted += '"';
    return quoted;
}

std::string toml_comment(const std::string& sentence) {
    std::istringstream words(sentence);  // also breaks at ends of lines, which would end the comment
    std::string text;
    std::string line(1, '#');
    for (std::string word; words >> word;) {
        for (char& c : word)
            if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
        if (line.size() > 1 && line.size() + 1 + word.size() > widest_comment) {
            text += line;
            text += '\n';
            line.assign(1, '#');
        }
        line += ' ';
        line += word;
    }
    text += line;
    text += '\n';
    return text;
}

}  // namespace runout
