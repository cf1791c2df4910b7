#include "core/csv_rows.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "core/text_file.h"
#include "core/words.h"

namespace runout {
namespace {

std::string_view unquoted(std::string_view text) {
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
    return trimmed(text);
}

std::vector<std::string> split(std::string_view line) {
    std::vector<std::string> fields;
    for (std::size_t begin = 0; begin <= line.size();) {
        const auto end = std::min(line.find(',', begin), line.size());
        fields.emplace_back(unquoted(trimmed(line.substr(begin, end - begin))));
        begin = end + 1;
    }
    return fields;
}

}  // namespace

std::vector<CsvRow> read_csv_rows(const std::string& path, const std::string& valid) {
    const std::string text = read_text_file(path, valid);
    std::vector<CsvRow> rows;
    int line = 1;
    for (std::size_t begin = 0; begin < text.size(); ++line) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        std::string_view rest = std::string_view(text).substr(begin, end - begin);
        begin = end + 1;
        if (line == 1 && rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
        rest = trimmed(rest.substr(0, rest.find('#')));
        if (!rest.empty()) rows.push_back({line, split(rest)});
    }
    return rows;
}

double csv_number(const InputPlace& place, const std::string& valid) {
    const std::string& text = place.value;
    const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const char* end = text.data() + text.size();
    if (begin == end) throw InputError(place, "is empty", valid);
    double value = 0;
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error == std::errc::invalid_argument || stop != end)
        throw InputError(place, "is not a number", valid);
    if (error == std::errc::result_out_of_range || !std::isfinite(value))
        throw InputError(place, "is not a finite number", valid);
    return value;
}

}  // namespace runout
