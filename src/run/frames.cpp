#include "run/frames.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace runout {
namespace {

/// Numbers from `low` on in equal steps, `codes` of them.
struct Scale {
    double low = 0, step = 1;

    [[nodiscard]] double code(float value) const { return std::round((value - low) / step); }
};

/// Spans all values of one field over all pictures.
template <class Pictures, class Field>
Scale scale_of(const Pictures& pictures, Field field, double codes) {
    float low = 0, high = 0;
    bool any = false;
    for (const auto& picture : pictures)
        for (const float value : picture.*field) {
            if (!std::isfinite(value)) continue;
            low = any ? std::min(low, value) : value;
            high = any ? std::max(high, value) : value;
            any = true;
        }
    if (!(high > low)) return {low, 1.0};
    return {low, (static_cast<double>(high) - low) / (codes - 1)};
}

template <class Code>
std::vector<Code> coded(const std::vector<float>& values, const Scale& scale) {
    std::vector<Code> codes;
    codes.reserve(values.size());
    const double most = static_cast<double>(std::numeric_limits<Code>::max());
    for (const float value : values)  // what is no number stands at the low end: a diverged run has such
        codes.push_back(
            static_cast<Code>(std::isfinite(value) ? std::clamp(scale.code(value), 0.0, most) : 0.0));
    return codes;
}

}  // namespace

bool is_shown(int id, std::size_t particles) {
    if (particles <= frame_particles) return true;
    const double share = static_cast<double>(frame_particles) / static_cast<double>(particles);
    const double turns = id * (std::numbers::phi - 1.0);
    return turns - std::floor(turns) < share;
}

void FrameRecorder::sample(const Simulation& simulation, bool last) {
    if (most_ == 0 || !simulation.released()) return;
    const double time = simulation.time();
    if (!last && time < due_) return;
    if (!pictures_.empty() && time <= pictures_.back().time_s) return;
    take(simulation.state());
    while (due_ <= time) due_ += interval_;
    if (!last && pictures_.size() > most_) thin_out();
    if (last && pictures_.size() > std::max<std::size_t>(most_, 2)) pictures_.erase(pictures_.end() - 2);
}

void FrameRecorder::take(const StateView& state) {
    // In the order of packing, so that a particle has the same place in every picture.
    std::vector<std::size_t> place(state.x.size());
    for (std::size_t i = 0; i < state.x.size(); ++i) place[static_cast<std::size_t>(state.id[i])] = i;
    Picture& picture = pictures_.emplace_back();
    picture.time_s = state.time;
    // Later layers of a staged release must not change the choice.
    if (particles_at_release_ == 0) particles_at_release_ = place.size();
    for (std::size_t id = 0; id < place.size(); ++id) {
        if (!is_shown(static_cast<int>(id), particles_at_release_)) continue;
        const std::size_t i = place[id];
        picture.x_m.push_back(static_cast<float>(state.x[i]));
        picture.y_m.push_back(static_cast<float>(state.y[i]));
        picture.speed_m_s.push_back(static_cast<float>(std::hypot(state.vx[i], state.vy[i])));
        picture.pressure_pa.push_back(static_cast<float>(state.pressure[i]));
    }
}

void FrameRecorder::thin_out() {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < pictures_.size(); k += 2) {
        if (kept != k) pictures_[kept] = std::move(pictures_[k]);
        ++kept;
    }
    pictures_.resize(kept);
    interval_ *= 2;
    due_ = pictures_.back().time_s + interval_;
}

std::vector<Frame> FrameRecorder::frames() const {
    constexpr double words = 65536, bytes = 256;
    const Scale x = scale_of(pictures_, &Picture::x_m, words), y = scale_of(pictures_, &Picture::y_m, words);
    const Scale speed = scale_of(pictures_, &Picture::speed_m_s, bytes);
    const Scale pressure = scale_of(pictures_, &Picture::pressure_pa, bytes);
    std::vector<Frame> frames;
    for (const Picture& picture : pictures_)
        frames.push_back({{picture.time_s, x.low, x.step, y.low, y.step, speed.low, speed.step, pressure.low,
                           pressure.step},
                          coded<std::uint16_t>(picture.x_m, x),
                          coded<std::uint16_t>(picture.y_m, y),
                          coded<std::uint8_t>(picture.speed_m_s, speed),
                          coded<std::uint8_t>(picture.pressure_pa, pressure)});
    return frames;
}

}  // namespace runout
