#include "scene/toml_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "core/text_file.h"

namespace runout {
namespace {

constexpr std::size_t longest_text = 4'000'000;  // bytes
constexpr int deepest_brackets = 16;             // lists in lists, tables in tables; a case has two
constexpr int most_dots = 16;                    // of one key; a case has three

InputPlace at(const std::string& path, int line = 0) {
    return {.file = path, .line = line, .key = {}, .value = {}};
}

/// Where the string that begins at `begin` ends, as TOML has it: one past its last quote, or the end of the
/// line for a string of one line that has none.
std::size_t end_of_string(std::string_view text, std::size_t begin) {
    const char quote = text[begin];
    const std::string_view three = quote == '"' ? R"(""")" : "'''";
    const bool many_lines = text.substr(begin).starts_with(three);
    std::size_t i = begin + (many_lines ? 3 : 1);
    while (i < text.size()) {
        if (quote == '"' && text[i] == '\\') {
            i += 2;
        } else if (!many_lines && (text[i] == quote || text[i] == '\n')) {
            return i + (text[i] == quote ? 1 : 0);
        } else if (many_lines && text.substr(i).starts_with(three)) {
            i += 3;
            for (int more = 0; more < 2 && i < text.size() && text[i] == quote; ++more) ++i;
            return i;
        } else {
            ++i;
        }
    }
    return text.size();
}

/// The parser calls itself for each level, so that some ten thousand levels end the program. Between two of
/// = , [ ] { } and the end of the line stands one key or one value, and dots between words make it deep.
void check_nesting(std::string_view text, const std::string& path) {
    int line = 1, brackets = 0, dots = 0;
    for (std::size_t i = 0; i < text.size();) {
        const char c = text[i];
        if (c == '"' || c == '\'') {
            const std::size_t end = end_of_string(text, i);
            line += static_cast<int>(std::count(text.begin() + static_cast<std::ptrdiff_t>(i),
                                                text.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
            i = end;
            continue;
        }
        if (c == '#') {
            i = std::min(text.find('\n', i), text.size());
            continue;
        }
        if (c == '[' || c == '{') ++brackets;
        if (c == ']' || c == '}') --brackets;
        if (c == '.') ++dots;
        if (std::string_view("=,[]{}\n").find(c) != std::string_view::npos) dots = 0;
        if (c == '\n') ++line;
        if (brackets > deepest_brackets)
            throw InputError(at(path, line), fmt::format("has more than {} brackets open", deepest_brackets),
                             "close them; a list of points has two");
        if (dots > most_dots)
            throw InputError(at(path, line), fmt::format("has a key of more than {} parts", most_dots + 1),
                             "write section.key = value");
        ++i;
    }
}

}  // namespace

std::string read_toml_text(const std::string& path, const std::string& valid) {
    std::string text = read_text_file(path, valid);
    if (text.size() > longest_text)
        throw InputError(at(path), fmt::format("is longer than {:.0f} MB", 1e-6 * longest_text), valid);
    return text;
}

toml::table parse_toml(const std::string& text, const std::string& path) {
    check_nesting(text, path);
    try {
        return toml::parse(text, path);
    } catch (const toml::parse_error& error) {
        throw InputError(at(path, static_cast<int>(error.source().begin.line)),
                         fmt::format("is not valid TOML ({})", error.description()), "write key = value");
    }
}

std::optional<double> number_in(const toml::node& node) {
    if (const auto* whole = node.as_integer()) return static_cast<double>(whole->get());
    if (const auto* real = node.as_floating_point()) return real->get();
    return std::nullopt;
}

}  // namespace runout
