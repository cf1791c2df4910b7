#include "report/text/intensity.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>

#include "core/input_error.h"

namespace runout {
namespace {

std::optional<double> number_in(const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !(value >= 0) || !std::isfinite(value))
        return std::nullopt;
    return value;
}

InputError unclear(const std::string& text, const std::string& option, const std::string& problem) {
    return InputError({.file = {}, .line = 0, .key = option, .value = text}, problem,
                      "give NAME=THICKNESS,SPEED in m and m/s, such as high=1,1, the least class first");
}

}  // namespace

std::vector<IntensityClass> usual_intensities() {
    return {{"medium", 0, 0}, {"high", 1, 1}};
}

std::string usual_intensities_origin() {
    return "Default classes, not yet checked against a source: high where it is thicker than 1 m and faster "
           "than 1 m/s, else medium; there is no low one. Give your own by --intensity.";
}

std::string intensity_of(const std::vector<IntensityClass>& classes, double thickness_m, double speed_m_s) {
    std::string name;
    for (const IntensityClass& each : classes)
        if (thickness_m > each.thickness_m && (speed_m_s > each.speed_m_s || each.speed_m_s == 0))
            name = each.name;
    return name;
}

std::vector<IntensityStretch> intensity_stretches(const Envelope& envelope, double front_thickness_m,
                                                  const std::vector<IntensityClass>& classes) {
    std::vector<IntensityStretch> stretches;
    for (std::size_t i = 0; i < envelope.greatest_thickness_m.size(); ++i) {
        if (!(envelope.greatest_thickness_m[i] >= front_thickness_m)) continue;
        const std::string name =
            intensity_of(classes, envelope.greatest_thickness_m[i], envelope.greatest_speed_m_s[i]);
        if (name.empty()) continue;
        const double middle = envelope.first_m + static_cast<double>(i) * envelope.step_m;
        const double from = middle - 0.5 * envelope.step_m, to = middle + 0.5 * envelope.step_m;
        const bool goes_on = !stretches.empty() && stretches.back().name == name &&
                             from - stretches.back().to_m < 0.1 * envelope.step_m;
        if (goes_on)
            stretches.back().to_m = to;
        else
            stretches.push_back({name, from, to});
    }
    return stretches;
}

IntensityClass intensity_from(const std::string& text, const std::string& option) {
    const std::size_t equals = text.find('='),
                      comma = text.find(',', equals == std::string::npos ? 0 : equals);
    if (equals == std::string::npos || comma == std::string::npos || equals == 0)
        throw unclear(text, option, "is no class of intensity");
    const auto thickness = number_in(text.substr(equals + 1, comma - equals - 1));
    const auto speed = number_in(text.substr(comma + 1));
    if (!thickness || !speed) throw unclear(text, option, "has no two numbers that are not negative");
    return {text.substr(0, equals), *thickness, *speed};
}

Intensities intensities_from(const std::vector<std::string>& texts, const std::string& option) {
    if (texts.empty()) return {};
    Intensities given{{}, fmt::format("Classes as given by {}.", option)};
    for (const std::string& text : texts) given.classes.push_back(intensity_from(text, option));
    check_intensities_rise(given.classes, option);
    return given;
}

void check_intensities_rise(const std::vector<IntensityClass>& classes, const std::string& option) {
    for (std::size_t i = 1; i < classes.size(); ++i) {
        const IntensityClass &before = classes[i - 1], &here = classes[i];
        const bool rises = here.thickness_m >= before.thickness_m && here.speed_m_s >= before.speed_m_s &&
                           (here.thickness_m > before.thickness_m || here.speed_m_s > before.speed_m_s);
        if (!rises) throw unclear(here.name, option, "is not above " + before.name);
    }
}

}  // namespace runout
