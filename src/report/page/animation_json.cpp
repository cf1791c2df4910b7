#include "report/page/animation_json.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/printable.h"
#include "report/page/section_figure.h"

namespace runout {
namespace {

using Json = nlohmann::json;

std::string base64(const unsigned char* bytes, std::size_t count) {
    constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((count + 2) / 3 * 4);
    for (std::size_t i = 0; i < count; i += 3) {
        unsigned group = 0;
        for (std::size_t k = 0; k < 3; ++k) group = group << 8U | (i + k < count ? bytes[i + k] : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k > count ? '=' : letters[group >> (18U - 6U * k) & 63U];
    }
    return text;
}

template <class Code>
std::string base64(const std::vector<Code>& codes) {
    return base64(reinterpret_cast<const unsigned char*>(codes.data()), codes.size() * sizeof(Code));
}

Json points(const Polyline& line) {
    Json list = Json::array();
    for (const Vec2& point : line) list.push_back({point.x(), point.y()});
    return list;
}

Json json_places(const RunData& run, const SectionWindow& view) {
    Json list = Json::array();
    for (const PlaceRecord& place : run.run.places)
        list.push_back({{"name", printable(place.name)}, {"posts", points(place_posts(run, place, view))}});
    return list;
}

Json json_frame(const Frame& frame) {
    return {{"time", frame.scale.time_s},
            {"x", base64(frame.x)},
            {"y", base64(frame.y)},
            {"speed", base64(frame.speed)},
            {"pressure", base64(frame.pressure)}};
}

/// Every `step`-th frame, and the last.
Json json_frames(const std::vector<Frame>& frames, std::size_t step) {
    Json list = Json::array();
    for (std::size_t k = 0; k < frames.size(); ++k)
        if (k % step == 0 || k + 1 == frames.size()) list.push_back(json_frame(frames[k]));
    return list;
}

std::size_t step_for(const std::vector<Frame>& frames, std::size_t most_bytes) {
    std::size_t bytes = 0;
    for (const Frame& frame : frames) bytes += frame.x.size() * 8 + 100;  // six bytes are eight in base64
    return std::max<std::size_t>(1, (bytes + most_bytes - 1) / most_bytes);
}

/// Side of the square that a shown particle stands for, m.
double shown_size(const RunData& run) {
    const double share =
        static_cast<double>(run.run.work.particles) / static_cast<double>(run.frames.back().x.size());
    return run.run.work.particle_spacing_m * std::sqrt(std::max(1.0, share));
}

}  // namespace

std::string animation_json(const RunData& run, std::size_t most_bytes) {
    if (run.frames.empty() || run.frames.back().x.empty()) return {};
    const SectionWindow view = section_view(run);
    const FrameScale& scale = run.frames.front().scale;
    const Json json = {{"view", {view.low.x(), view.low.y(), view.high.x(), view.high.y()}},
                       {"bed", points(clipped(run.geometry.bed, view.low.x(), view.high.x()))},
                       {"source", points(run.geometry.outline)},
                       {"deposit", points(deposit_surface(run))},
                       {"places", json_places(run, view)},
                       {"size", shown_size(run)},
                       {"x", {scale.x_low_m, scale.x_step_m}},
                       {"y", {scale.y_low_m, scale.y_step_m}},
                       {"speed", {scale.speed_low_m_s, scale.speed_step_m_s}},
                       {"pressure", {scale.pressure_low_pa, scale.pressure_step_pa}},
                       {"frames", json_frames(run.frames, step_for(run.frames, most_bytes))}};
    return json.dump();
}

}  // namespace runout
