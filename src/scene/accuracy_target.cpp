#include "scene/accuracy_target.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace runout {

double AccuracyTarget::metres_of(double run_out, double root_area) const {
    return metres > 0 ? metres : share * std::max(run_out, root_area);
}

std::string AccuracyTarget::text() const {
    return metres > 0 ? fmt::format("{:.4g} m", metres) : fmt::format("{:.4g} %", 100.0 * share);
}

AccuracyTarget accuracy_target(const std::string& text, const InputPlace& place) {
    constexpr const char* valid =
        "give a share of the run-out, such as \"5%\", or a length, such as \"0.25 m\"";
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{}) throw InputError(place, "is not a percentage or a length", valid);
    std::string unit(end, text.data() + text.size());
    std::erase(unit, ' ');
    if (unit.empty()) throw InputError(place, "has no unit", valid);
    if (unit != "%" && unit != "m")
        throw InputError(place, fmt::format("has the unknown unit {}", unit), valid);
    if (!(number > 0) || !std::isfinite(number)) throw InputError(place, "is not positive", valid);
    if (unit == "%" && number >= 100) throw InputError(place, "is not below 100 %", valid);
    return unit == "%" ? AccuracyTarget{0.01 * number, 0} : AccuracyTarget{0, number};
}

}  // namespace runout
