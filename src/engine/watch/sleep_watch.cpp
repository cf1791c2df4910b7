#include "engine/watch/sleep_watch.h"

#include <algorithm>
#include <cmath>

#include "engine/threads/node_array.h"
#include "engine/threads/parallel.h"

namespace runout {
namespace {

constexpr double cell_spacings = 3.0;  // more than a kernel support
constexpr int quiet_windows = 2;       // in a row, before soil sleeps
constexpr double quiet_motion = 0.02;  // spacings in a window
constexpr double waking_motion = 0.025;
constexpr double quiet_load = 0.2;  // of rho g dl, and a tenth of it of the pressure, in a window
constexpr double waking_load = 0.5;
constexpr double load_share = 0.1;
// Of the motion from one window to the next; beyond it soil is about to slide.
constexpr double fastest_growth = 1.5;
constexpr double least_motion = 0.002;  // spacings in a window; less counts as none

}  // namespace

SleepWatch::SleepWatch(const Discretisation& discretisation, double gravity, double window, int threads)
    : threads_(threads),
      spacing_(discretisation.spacing),
      unit_(discretisation.density * gravity * discretisation.spacing),
      window_(window) {
    grid_.size = cell_spacings * spacing_;
}

void SleepWatch::wake_all(const Soil& soil, double time) {
    mark_.assign(static_cast<std::size_t>(soil.count), Mark{});
    for (int i = 0; i < soil.count; ++i) {
        mark_[soil.id[i]].place = {soil.x[i], soil.y[i]};
        mark_[soil.id[i]].pressure = soil.pressure[i];
    }
    sleepers_ = 0;
    opened_ = time;
}

void SleepWatch::append(const Soil& soil) {
    const std::size_t before = mark_.size();
    mark_.resize(static_cast<std::size_t>(soil.count));
    for (int i = 0; i < soil.count; ++i) {
        if (static_cast<std::size_t>(soil.id[i]) >= before) mark_[soil.id[i]].place = {soil.x[i], soil.y[i]};
    }
}

/// Marks the cells in which a particle has moved by more than `motion` spacings since the window opened, or
/// its load changed by more than `load`.
void SleepWatch::find_restless(const Soil& soil, double motion, double load) {
    if (shares_.empty() || shares_.back() != soil.count) shares_ = even_shares(soil.count, threads_);
    grid_.cover(soil.x, soil.y, shares_);
    set_all(restless_, grid_.start.size(), char{0});
    fit(is_restless_, static_cast<std::size_t>(soil.count));
    const double far2 = motion * motion * spacing_ * spacing_;
    for_each_share(shares_, [&](int, int first, int last) {
        for (int i = first; i < last; ++i) {
            const Mark& mark = mark_[soil.id[i]];
            const double changed = std::abs(soil.pressure[i] - mark.pressure);
            is_restless_[i] = (Vec2{soil.x[i], soil.y[i]} - mark.place).squaredNorm() > far2 ||
                              changed > load * (unit_ + load_share * std::abs(mark.pressure));
        }
    });
    for (int i = 0; i < soil.count; ++i) {
        if (is_restless_[i]) restless_[grid_.cell_of[i]] = 1;
    }
}

/// Marks the cells in which motion grows: that soil is about to slide.
void SleepWatch::find_growing(const Soil& soil) {
    set_all(growth_, restless_.size(), Growth{});
    for (int i = 0; i < soil.count; ++i) {
        const Mark& mark = mark_[soil.id[i]];
        Growth& growth = growth_[grid_.cell_of[i]];
        growth.moved += (Vec2{soil.x[i], soil.y[i]} - mark.place).norm();
        growth.before += mark.moved;
        ++growth.particles;
    }
    for (std::size_t c = 0; c < growth_.size(); ++c) {
        const Growth& growth = growth_[c];
        if (growth.moved > fastest_growth * growth.before + least_motion * spacing_ * growth.particles)
            restless_[c] = 1;
    }
}

/// Marks each restless cell and the cells around it as disturbed.
void SleepWatch::spread(const Soil& soil) {
    set_all(disturbed_, restless_.size(), char{0});
    for (int i = 0; i < soil.count; ++i) {
        char& restless = restless_[grid_.cell_of[i]];
        if (restless == 0) continue;
        restless = 0;  // once for all particles in it
        grid_.cells_around(grid_.window_of(soil.x[i], soil.y[i]), 1, [&](std::size_t low, std::size_t high) {
            std::fill(disturbed_.begin() + static_cast<std::ptrdiff_t>(low),
                      disturbed_.begin() + static_cast<std::ptrdiff_t>(high) + 1, char{1});
        });
    }
}

void SleepWatch::observe(const Soil& soil, const std::vector<double>& density, double time) {
    if (sleepers_ > 0) wake(soil);
    if (time - opened_ >= window_) close_window(soil, density, time);
}

void SleepWatch::wake(const Soil& soil) {
    find_restless(soil, waking_motion, waking_load);
    spread(soil);
    for (int i = 0; i < soil.count; ++i) {
        Mark& mark = mark_[soil.id[i]];
        if (!mark.asleep || !disturbed_[grid_.cell_of[i]]) continue;
        mark.asleep = false;
        mark.quiet_windows = 0;
        --sleepers_;
    }
}

void SleepWatch::close_window(const Soil& soil, const std::vector<double>& density, double time) {
    find_restless(soil, quiet_motion, quiet_load);
    find_growing(soil);
    spread(soil);
    for (int i = 0; i < soil.count; ++i) {
        Mark& mark = mark_[soil.id[i]];
        const Vec2 place{soil.x[i], soil.y[i]};
        if (!mark.asleep) {
            mark.quiet_windows = disturbed_[grid_.cell_of[i]] ? 0 : mark.quiet_windows + 1;
            mark.asleep = mark.quiet_windows >= quiet_windows;
            mark.density = density[i];
            sleepers_ += mark.asleep ? 1 : 0;
        }
        mark.moved = (place - mark.place).norm();
        mark.place = place;
        mark.pressure = soil.pressure[i];
    }
    opened_ = time;
}

int SleepWatch::find_sleeping(const Soil& soil, std::vector<char>& asleep) const {
    asleep.clear();
    if (sleepers_ == 0) return 0;
    const int slices = soil.padded() / lanes;
    set_all(asleep, static_cast<std::size_t>(slices), char{1});
    for (int i = 0; i < soil.count; ++i) {
        if (!mark_[soil.id[i]].asleep) asleep[static_cast<std::size_t>(i / lanes)] = 0;
    }
    int count = 0;
    for (int s = 0; s < slices; ++s) {
        if (asleep[static_cast<std::size_t>(s)] != 0) count += std::min(lanes, soil.count - s * lanes);
    }
    if (count == 0) asleep.clear();
    return count;
}

}  // namespace runout
