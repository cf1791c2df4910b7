#include "profile/line_attributes.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>

#include "core/input_error.h"

namespace runout {
namespace {

/// Names of fields in a shapefile end here.
constexpr std::size_t longest_shapefile_name = 10;

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// NaN when it is no number of metres.
double metres_in(std::string_view text) {
    if (text.ends_with('m') || text.ends_with('M')) text = trimmed(text.substr(0, text.size() - 1));
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
    return whole ? value : std::nan("");
}

void take_attribute(double& option, const std::string& key, const SectionLine& line,
                    const std::string& file) {
    if (!std::isnan(option)) return;  // what the user says comes first
    for (const std::string& name : {key, key.substr(0, longest_shapefile_name)}) {
        const std::string text = attribute_text(line.map.attributes, {name});
        const std::string_view written = trimmed(text);
        if (written.empty()) continue;
        option = metres_in(written);
        if (!std::isnan(option)) return;
        throw InputError({file, 0, fmt::format("feature {}, {}", line.feature_id, name), text},
                         "is not a number", "give the chainage in metres, such as 36.5, or leave it empty");
    }
}

}  // namespace

ProfileOptions with_attributes(ProfileOptions options, const SectionLine& line, const std::string& file) {
    take_attribute(options.toe_chainage_m, "toe_chainage_m", line, file);
    take_attribute(options.crest_chainage_m, "crest_chainage_m", line, file);
    return options;
}

}  // namespace runout
