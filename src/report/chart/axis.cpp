#include "report/chart/axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace runout {
namespace {

constexpr std::array<double, 3> nice = {1.0, 2.0, 5.0};
constexpr double slack = 1e-9;  // of a tick distance: rounding must not cost the tick at an end

/// The least of 1, 2, 5 times a power of ten that is not below `least`.
double nice_step(double least) {
    const double decade = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : nice)
        if (factor * decade >= least * (1.0 - slack)) return factor * decade;
    return 10.0 * decade;
}

double step_for(const AxisRange& range, int tick_count) {
    return nice_step(range.length() / std::max(1, tick_count));
}

// Counted, not summed up, so that rounding does not grow along the axis and zero is zero.
std::vector<double> multiples(double step, double low, double high) {
    std::vector<double> ticks;
    const double first = std::ceil(low / step - slack), last = std::floor(high / step + slack);
    for (double k = first; k <= last; ++k) ticks.push_back(k * step + 0.0);
    return ticks;
}

/// 1, 2 and 5 of every decade; only 1, and only every so many decades, when `every` is not zero.
std::vector<double> ticks_of_decades(int first, int last, int every) {
    std::vector<double> ticks;
    for (int exponent = first; exponent <= last; exponent += std::max(1, every))
        for (const double factor : nice)
            if (every == 0 || factor == 1.0) ticks.push_back(factor * std::pow(10.0, exponent));
    return ticks;
}

/// Numbers from the last tick not above `low` to the first not below `high`; at least two.
std::vector<double> around(const std::vector<double>& ticks, double low, double high) {
    auto first = std::ranges::upper_bound(ticks, low * (1.0 + slack));
    auto last = std::ranges::lower_bound(ticks, high * (1.0 - slack));
    if (first != ticks.begin()) --first;
    if (first == last && first != ticks.begin()) --first;
    return {first, last == ticks.end() ? last : last + 1};
}

}  // namespace

void AxisRange::include(double value) {
    const bool first = empty();
    low_ = first ? value : std::min(low_, value);
    high_ = first ? value : std::max(high_, value);
}

AxisRange AxisRange::widened_to(double length) const {
    AxisRange wide;
    const double middle = 0.5 * (low_ + high_);
    wide.include(middle - 0.5 * length);
    wide.include(middle + 0.5 * length);
    return wide;
}

double Axis::position(double value) const {
    if (logarithmic) return std::log(value / low) / std::log(high / low);
    return (value - low) / (high - low);
}

AxisRange drawable(const AxisRange& data) {
    AxisRange range = data;
    if (range.empty()) {
        range.include(0.0);
        range.include(1.0);
    }
    const double size = std::max(std::abs(range.low()), std::abs(range.high()));
    if (range.length() > std::max(1e-9 * size, 1e-100)) return range;
    return range.widened_to(size > 1e-100 ? 0.1 * size : 1.0);
}

Axis fixed_axis(const AxisRange& range, int tick_count) {
    Axis axis{range.low(), range.high(), false, {}};
    // A single number tells no scale.
    for (int count = tick_count; axis.ticks.size() < 2; ++count)
        axis.ticks = multiples(step_for(range, count), range.low(), range.high());
    return axis;
}

Axis linear_axis(const AxisRange& data, int tick_count) {
    const AxisRange range = drawable(data);
    const double step = step_for(range, tick_count);
    const double low = step * std::floor(range.low() / step + slack);
    const double high = step * std::ceil(range.high() / step - slack);
    return {low, high, false, multiples(step, low, high)};
}

Axis logarithmic_axis(const AxisRange& data, int tick_count) {
    const double low = data.empty() ? 1.0 : data.low(), high = data.empty() ? 10.0 : data.high();
    const int first = static_cast<int>(std::floor(std::log10(low))) - 1;
    const int last = static_cast<int>(std::ceil(std::log10(high))) + 1;
    std::vector<double> ticks = around(ticks_of_decades(first, last, 0), low, high);
    const double from = ticks.front(), to = ticks.back();
    for (int every = 1; static_cast<int>(ticks.size()) > std::max(2, tick_count); ++every) {
        ticks = ticks_of_decades(first, last, every);
        std::erase_if(ticks, [&](double t) { return t < from * (1.0 - slack) || t > to * (1.0 + slack); });
    }
    return {from, to, true, ticks};
}

std::vector<std::string> tick_labels(const Axis& axis) {
    std::vector<std::string> labels;
    // Six digits write particle numbers out; ticks are round, so that few of the digits are ever seen.
    for (int digits = 6; digits <= 15; ++digits) {
        labels.clear();
        for (const double tick : axis.ticks) labels.push_back(fmt::format("{:.{}g}", tick, digits));
        if (std::set<std::string>(labels.begin(), labels.end()).size() == labels.size()) break;
    }
    return labels;
}

}  // namespace runout
