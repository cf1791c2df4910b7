#include "profile/line_attributes.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>

#include "core/input_error.h"
#include "core/words.h"

namespace runout {
namespace {

/// Names of fields in a shapefile end here.
constexpr std::size_t longest_shapefile_name = 10;

constexpr std::string_view blanks = " \t";

/// NaN when it is no number of metres.
double metres_in(std::string_view text) {
    if (text.ends_with('m') || text.ends_with('M')) text = trimmed(text.substr(0, text.size() - 1), blanks);
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
    return whole ? value : std::nan("");
}

void take_attribute(Chainage& option, const std::string& key, const SectionLine& line,
                    const std::string& file) {
    if (option.is_known()) return;  // what the user says comes first
    for (const std::string& name : {key, key.substr(0, longest_shapefile_name)}) {
        const std::string text = attribute_text(line.map.attributes, {name});
        const std::string_view written = trimmed(text, blanks);
        if (written.empty()) continue;
        option = Chainage(metres_in(written));
        if (option.is_known()) return;
        throw InputError({file, 0, fmt::format("feature {}, {}", line.feature_id, name), text},
                         "is not a number", "give the chainage in metres, such as 36.5, or leave it empty");
    }
}

}  // namespace

ProfileOptions with_attributes(ProfileOptions options, const SectionLine& line, const std::string& file) {
    take_attribute(options.toe_chainage, "toe_chainage_m", line, file);
    take_attribute(options.crest_chainage, "crest_chainage_m", line, file);
    return options;
}

}  // namespace runout
