#include "program/progress_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "program/log.h"

namespace runout {
namespace {

constexpr int bar_width = 30;

// Before this share of the run is done an estimate of the rest is a guess.
constexpr double least_fraction_for_estimate = 0.03;

std::string time_left(const Progress& progress) {
    if (progress.fraction < least_fraction_for_estimate) return "estimating the time left";
    const double left = progress.wall_s * (1 - progress.fraction) / progress.fraction;
    return fmt::format("{} left, {} at most", duration_text(left),
                       duration_text(std::max(left, progress.most_left_s)));
}

std::string bar_text(const Progress& progress) {
    const int filled = static_cast<int>(std::lround(progress.fraction * bar_width));
    return fmt::format("[{}{}] {:3.0f} %  {:.3g} s simulated, {}", std::string(filled, '#'),
                       std::string(bar_width - filled, '.'), 100 * progress.fraction, progress.time_s,
                       time_left(progress));
}

}  // namespace

ProgressLine::Style ProgressLine::style_of_stderr() {
    return isatty(STDERR_FILENO) == 1 ? Style::bar : Style::lines;
}

void ProgressLine::show(const Progress& reported) {
    Progress progress = reported;
    progress.fraction = std::isfinite(reported.fraction) ? std::clamp(reported.fraction, 0.0, 1.0) : 0.0;
    if (style_ == Style::bar) {
        fmt::print(stderr, "\r{}\033[K",
                   bar_text(progress));  // the escape clears what a longer line left behind
        std::fflush(stderr);
        bar_is_drawn_ = true;
    }
    const int tenths = static_cast<int>(progress.fraction * 10);
    if (style_ == Style::lines && tenths > tenths_shown_) {
        tenths_shown_ = tenths;
        log_info("{} % done, {:.3g} s simulated, {}", 10 * tenths, progress.time_s, time_left(progress));
    }
}

void ProgressLine::finish() {
    if (!bar_is_drawn_) return;
    fmt::print(stderr, "\r\033[K");
    std::fflush(stderr);
    bar_is_drawn_ = false;
}

std::string duration_text(double seconds) {
    const long whole = std::lround(std::max(seconds, 0.0));
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
    return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace runout
