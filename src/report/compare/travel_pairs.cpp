#include <charconv>
#include <stdexcept>
#include <string_view>

#include "report/compare/travel_relations.h"
#include "report/page/page_files.h"

namespace runout {
namespace {

/// Takes what stands before the next `mark` off the front of `text`.
std::string_view take(std::string_view& text, char mark) {
    const std::size_t end = text.find(mark);
    const std::string_view taken = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    return taken;
}

double number(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size())
        throw std::logic_error("data/travel_angles.csv holds \"" + std::string(text) + "\" for a number");
    return value;
}

std::string group_of(std::string_view kind, std::string_view origin) {
    if (origin.find("Hong Kong") != std::string_view::npos) return "Hong Kong";
    return kind == "wet" ? "wet, elsewhere" : "dry";
}

/// Rows "class,volume_m3,travel_angle_deg,source" below a line of names; # starts a comment.
std::vector<TravelPair> read_pairs(std::string_view text) {
    std::vector<TravelPair> pairs;
    bool in_header = true;
    while (!text.empty()) {
        std::string_view line = take(text, '\n');
        if (line.empty() || line.front() == '#') continue;
        if (in_header) {
            in_header = false;
            continue;
        }
        const std::string_view kind = take(line, ',');
        const double volume = number(take(line, ',')), angle = number(take(line, ','));
        pairs.push_back({group_of(kind, line), volume, angle});
    }
    return pairs;
}

}  // namespace

const std::vector<TravelPair>& travel_pairs() {
    static const std::vector<TravelPair> pairs = read_pairs(page_file::travel_angles());
    return pairs;
}

}  // namespace runout
