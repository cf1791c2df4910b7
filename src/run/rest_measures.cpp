#include "run/rest_measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/units.h"
#include "measures/front_rule.h"

namespace runout {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double most_spray = 0.2;      // of the debris: beyond it there is no body to speak of
constexpr double spray_to_tell = 0.05;  // of the debris

double thickness_at_toe(const DepositProfile& profile) {
    for (const auto& bin : profile.bins) {
        if (bin.x > 0.0 && bin.x <= profile.bin_width) return bin.by_top;
    }
    return 0.0;
}

double greatest_thickness(const DepositProfile& profile) {
    double height = 0.0;
    for (const auto& bin : profile.bins) height = std::max(height, bin.by_top);
    return height;
}

/// Where the debris ends: on the bed, or as high as its soil lies there where the bed rises steeply.
Vec2 distal_margin(const StateView& state, double front, double window) {
    double highest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < state.x.size(); ++i)
        if (state.is_debris(i) && std::abs(state.x[i] - front) < window)
            highest = std::max(highest, state.y[i]);
    return {front, std::min(state.ground->elevation(front), highest)};
}

/// Angle below the horizontal from the head of the source to the distal margin, degrees.
double reach_angle(const Vec2& head, const Vec2& margin) {
    return degrees(std::atan2(head.y() - margin.y(), margin.x() - head.x()));
}

/// No number where there is no such front.
double from_toe(double x) {
    return x > ThicknessField::nowhere ? x : none;
}

/// 0 where it does not pass the toe.
double beyond_toe(double x) {
    return x > ThicknessField::nowhere ? std::max(0.0, x) : none;
}

void add_front(Measures& m, const Scene& scene, const EndState& end) {
    const StateView state = end.simulation.state();
    const FrontRule& rule = end.reach.soil().rule();
    const double front = end.reach.front();
    m.front_thickness_m = rule.threshold;
    m.front_window_m = rule.window;
    m.reach_angle_deg = none;
    m.beyond_front_area_m2 = none;
    m.farthest_front_m = m.farthest_soil_m = none;  // a source that stands reaches nothing
    if (end.simulation.status() == RunStatus::stable) return;
    m.run_out_m = beyond_toe(front);
    m.run_out_along_bed_m = front > ThicknessField::nowhere
                                ? std::max(0.0, distance_along_bed(*state.ground, std::max(0.0, front)))
                                : none;
    m.farthest_front_m = from_toe(end.reach.farthest_front());
    m.front_by_top_m =
        beyond_toe(contiguous_front(end.profile, &DepositProfile::Bin::by_top, rule.threshold));
    m.front_by_mass_m =
        beyond_toe(contiguous_front(end.profile, &DepositProfile::Bin::by_mass, rule.threshold));
    m.front_mass_995_m = beyond_toe(mass_front(state, 0.005));
    m.peak_front_speed_m_s = end.reach.peak_front_speed();
    m.peak_mass_995_speed_m_s = end.peak_mass_point_speed;
    m.farthest_soil_m = from_toe(end.reach.farthest_soil());
    m.beyond_front_speed_m_s = end.reach.speed_beyond_front();
    if (!(front > ThicknessField::nowhere)) return;
    m.reach_angle_deg = reach_angle(scene.source.head, distal_margin(state, front, rule.window));
    m.beyond_front_area_m2 = end.reach.soil().area_beyond(front);
}

/// Of the debris.
double spray_share(const Simulation& simulation, const Measures& measures) {
    const StateView state = simulation.state();
    double debris = 0;
    for (std::size_t i = 0; i < state.x.size(); ++i)
        if (state.is_debris(i)) debris += 1;
    return measures.stray_particles / debris;
}

}  // namespace

Measures measures_at_rest(const Scene& scene, const EndState& end) {
    const StateView state = end.simulation.state();
    const Source& source = scene.source;
    Measures m;
    add_front(m, scene, end);
    m.source_area_m2 = source.area;
    m.deposit_area_m2 = deposit_area(state, end.body);
    m.run_out_normalised = m.run_out_m / std::sqrt(m.deposit_area_m2);
    m.front_area_m2 = source.front_area;
    m.front_area_ratio = source.front_area / source.area;
    m.drop_height_m = source.drop_height;
    m.drop_height_normalised = source.drop_height / std::sqrt(m.deposit_area_m2);
    m.deposit_height_m = greatest_thickness(end.profile);
    m.toe_thickness_m = thickness_at_toe(end.profile);
    m.time_to_rest_s = end.simulation.motion_ended();
    m.eroded_area_m2 = scene.effects.erodible_bed ? end.simulation.eroded_area() : none;
    for (std::size_t i = 0; i < end.body.size(); ++i)
        if (end.body[i] == 0 && state.is_debris(i)) m.stray_particles += 1;
    return m;
}

StageRow stage_at_rest(const Scene& scene, const Simulation& simulation) {
    const StateView state = simulation.state();
    ThicknessField soil(front_rule(scene), state);
    soil.take(state);
    const DepositProfile profile = deposit_profile(state, connected_body(state));
    // The middle of the heap is that of the part that hangs together.
    const double end = contiguous_front(profile, &DepositProfile::Bin::by_top, soil.rule().threshold);
    return {simulation.time(), state.discretisation->volume() * static_cast<double>(state.x.size()),
            degrees(surface_angle(profile, end)), greatest_thickness(profile),
            soil.front() > ThicknessField::nowhere ? soil.front() : none};
}

Verdict verdict_on(const Simulation& simulation, const ReachRecorder& reach, const Measures& measures) {
    if (simulation.status() != RunStatus::settled) return {simulation.status(), simulation.status_detail()};
    const double end = simulation.state().ground->points().back().x();
    if (reach.farthest_front() > end)
        return {RunStatus::left_section,
                fmt::format("the front came within its window of {:.3g} m of the distal end of the section; "
                            "lengthen the section",
                            measures.front_window_m)};
    const double spray = spray_share(simulation, measures);
    if (spray > most_spray)
        return {RunStatus::not_a_body,
                fmt::format("{:.0f} % of the soil lie apart from the body; a finer spacing may hold together",
                            100 * spray)};
    if (!(reach.front() > ThicknessField::nowhere))
        return {RunStatus::not_a_body,
                fmt::format("the deposit is nowhere {:.3g} m thick in a window of {:.3g} m; give a lesser "
                            "run.front_thickness_m",
                            measures.front_thickness_m, measures.front_window_m)};
    return {RunStatus::settled, {}};
}

std::string spray_warning(const Simulation& simulation, const Measures& measures) {
    const double spray = spray_share(simulation, measures);
    if (simulation.status() == RunStatus::stable || spray <= spray_to_tell) return {};
    return fmt::format(
        "{:.0f} % of the soil lie apart from the body, as spray: the run-out may be that of single grains; "
        "a finer spacing holds more together.",
        100 * spray);
}

}  // namespace runout
