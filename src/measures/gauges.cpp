#include "measures/gauges.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace runout {
namespace {

constexpr double half_width_spacings = 2.0;  // of the strip that a gauge looks at

double area_beyond(const StateView& state, double x) {
    double area = 0.0;
    for (std::size_t i = 0; i < state.x.size(); ++i)
        if (state.x[i] > x && state.is_debris(i)) area += state.discretisation->volume();
    return area;
}

}  // namespace

GaugeRecorder::GaugeRecorder(const std::vector<Gauge>& gauges, double interval, double front_thickness)
    : gauges_(gauges), interval_(interval), front_thickness_(front_thickness) {
    for (const Gauge& gauge : gauges_) {
        GaugeRecord record;
        record.name = gauge.name;
        record.arrival_time_s = std::numeric_limits<double>::quiet_NaN();
        records_.push_back(std::move(record));
    }
}

/// Thickness and mean speed over depth of the soil in a strip around the gauge, weighted towards its middle.
GaugeRow GaugeRecorder::read(const StateView& state, std::size_t g) const {
    const double half = half_width_spacings * state.discretisation->spacing;
    double weight = 0.0, vx = 0.0, vy = 0.0;
    for (std::size_t i = 0; i < state.x.size(); ++i) {
        const double share = 1.0 - std::abs(state.x[i] - gauges_[g].x) / half;
        if (share <= 0.0 || !state.is_debris(i)) continue;
        weight += share;
        vx += share * state.vx[i];
        vy += share * state.vy[i];
    }
    GaugeRow row;
    row.time_s = state.time;
    row.thickness_m = weight * state.discretisation->volume() / half;
    row.passed_area_m2 = area_beyond(state, gauges_[g].x) - beyond_at_start_[g];
    if (weight <= 0.0) return row;
    const double speed = std::hypot(vx, vy) / weight;
    row.speed_m_s = vx < 0.0 ? -speed : speed;
    row.kinetic_head_m = 0.5 * speed * speed / state.gravity;
    return row;
}

void GaugeRecorder::sample(const StateView& state, bool always) {
    if (beyond_at_start_.empty())
        for (const Gauge& gauge : gauges_) beyond_at_start_.push_back(area_beyond(state, gauge.x));
    const bool store = always || state.time >= due_;
    if (state.time >= due_) due_ += interval_;
    for (std::size_t g = 0; g < gauges_.size(); ++g) {
        const GaugeRow row = read(state, g);
        GaugeRecord& record = records_[g];
        const bool arrived = row.thickness_m >= front_thickness_;
        if (arrived && std::isnan(record.arrival_time_s)) record.arrival_time_s = row.time_s;
        record.greatest_thickness_m = std::max(record.greatest_thickness_m, row.thickness_m);
        if (arrived) {  // single grains that fly ahead say nothing of the debris
            record.greatest_speed_m_s = std::max(record.greatest_speed_m_s, row.speed_m_s);
            record.greatest_kinetic_head_m = std::max(record.greatest_kinetic_head_m, row.kinetic_head_m);
        }
        record.passed_area_m2 = row.passed_area_m2;
        if (store && (record.rows.empty() || record.rows.back().time_s < row.time_s))
            record.rows.push_back(row);
    }
}

}  // namespace runout
