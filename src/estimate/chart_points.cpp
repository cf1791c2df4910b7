#include "estimate/chart_points.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "core/units.h"
#include "engine/status.h"
#include "scene/effect_settings.h"

namespace runout {
namespace {

constexpr std::array<ChartVariableText, chart_variables> texts = {{
    {"slope angle", "slope_angle_deg", " deg", 0.02},
    {"H_d/sqrt(S)", "drop_height_normalised", "", 0.002},
    {"S_front/S", "front_area_ratio", "", 0.001},
    {"friction angle", "friction_angle_deg", " deg", 0.02},
}};

constexpr double same_plane_deg = 1e-6;

ChartPoint point_of(const ChartRow& row) {
    const double length = std::sqrt(row.source_area_m2);
    return {row.run_id,
            {row.slope_angle_deg, row.head_height_m / length, row.front_area_m2 / row.source_area_m2,
             row.friction_angle_deg},
            row.run_out_m / length,
            length / row.particle_spacing_m};
}

}  // namespace

const ChartVariableText& text_of(ChartVariable variable) {
    return texts[static_cast<std::size_t>(variable)];
}

ChartQuestion chart_question(const Scene& scene) {
    const Source& source = scene.source;
    ChartQuestion question;
    question.place = {degrees(scene.profile.slope_angle), source.head.y() / std::sqrt(source.area),
                      source.front_area / source.area, degrees(scene.material.friction_angle)};
    for (const EffectSetting& setting : effect_settings(scene.effects, scene.profile))
        question.effects += fmt::format("{}{}.{} = {}", question.effects.empty() ? "" : ", ", setting.effect,
                                        setting.key, setting.value);
    question.discontinuity_angle_deg = degrees(source.discontinuity_angle);
    return question;
}

ChartPoints chart_points(const std::vector<ChartRow>& rows, const ChartQuestion& question) {
    ChartPoints found;
    std::map<std::pair<long, double>, ChartPoint> finest;  // in an order that depends on nothing else
    double plane = question.discontinuity_angle_deg;
    for (const ChartRow& row : rows) {
        if (row.effects != question.effects) {
            ++found.other_effects;
            continue;
        }
        if (row.status != to_string(RunStatus::settled) || !std::isfinite(row.run_out_m)) {
            ++(row.status == to_string(RunStatus::stable) ? found.standing : found.without_result);
            continue;
        }
        if (row.front_definition != current_front_definition) {
            ++found.former_fronts;
            continue;
        }
        if (std::isnan(plane)) plane = row.discontinuity_angle_deg;
        if (std::abs(row.discontinuity_angle_deg - plane) > same_plane_deg) {
            ++found.other_planes;
            continue;
        }
        const ChartPoint point = point_of(row);
        const auto [known, fresh] = finest.emplace(std::pair{row.source_id, row.friction_angle_deg}, point);
        if (fresh) continue;
        ++found.coarser;
        if (point.resolution >= known->second.resolution) known->second = point;
    }
    for (const auto& [asked, point] : finest) found.points.push_back(point);
    return found;
}

}  // namespace runout
