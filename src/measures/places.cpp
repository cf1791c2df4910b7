#include "measures/places.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace runout {

PlaceRecorder::PlaceRecorder(const std::vector<Place>& places, double interval, double density)
    : places_(places), interval_(interval), density_(density) {
    for (const Place& place : places_) {
        PlaceRecord record;
        record.name = place.name;
        record.kind = place.kind;
        record.width_m = place.width;
        record.arrival_time_s = std::numeric_limits<double>::quiet_NaN();
        records_.push_back(std::move(record));
    }
}

PlaceRow PlaceRecorder::read(const ThicknessField& soil, const StateView& state, std::size_t g) const {
    const SoilColumn column = soil.at(places_[g].x);
    PlaceRow row;
    row.time_s = state.time;
    row.thickness_m = column.thickness;
    row.passed_area_m2 = soil.area_beyond(places_[g].x) - beyond_at_start_[g];
    const double speed = column.velocity.norm();
    row.speed_m_s = column.velocity.x() < 0.0 ? -speed : speed;
    row.kinetic_head_m = 0.5 * speed * speed / state.gravity;
    return row;
}

void PlaceRecorder::take(const ThicknessField& soil, double gravity, double x, PlaceRecord& record) const {
    const SoilColumn column = soil.at(x);
    record.greatest_thickness_m = std::max(record.greatest_thickness_m, column.thickness);
    if (column.thickness < soil.rule().threshold) return;  // grains that fly ahead say nothing of the debris
    const double speed_2 = column.velocity.squaredNorm();
    record.greatest_speed_m_s = std::max(record.greatest_speed_m_s, std::sqrt(speed_2));
    record.greatest_kinetic_head_m = std::max(record.greatest_kinetic_head_m, 0.5 * speed_2 / gravity);
    record.greatest_momentum_flux_n_m =
        std::max(record.greatest_momentum_flux_n_m, density_ * speed_2 * column.thickness);
}

/// Both edges, and the nodes of the soil between them.
void PlaceRecorder::take_all(const ThicknessField& soil, double gravity, const Place& place,
                             PlaceRecord& record) const {
    take(soil, gravity, place.x, record);
    if (place.width <= 0) return;
    const double first = static_cast<double>(soil.first_node()) * soil.node_step();
    const double last = first + static_cast<double>(soil.nodes()) * soil.node_step();
    const double end = std::min(place.x + place.width, last);
    for (double x = std::max(place.x, first) + soil.node_step(); x < end; x += soil.node_step())
        take(soil, gravity, x, record);
    take(soil, gravity, place.x + place.width, record);
}

void PlaceRecorder::sample(const ReachRecorder& reach, const StateView& state, bool always) {
    const ThicknessField& soil = reach.soil();
    if (beyond_at_start_.empty())
        for (const Place& place : places_) beyond_at_start_.push_back(soil.area_beyond(place.x));
    const bool store = always || state.time >= due_;
    if (state.time >= due_) due_ += interval_;
    for (std::size_t g = 0; g < places_.size(); ++g) {
        const PlaceRow row = read(soil, state, g);
        PlaceRecord& record = records_[g];
        if (reach.farthest_front() >= places_[g].x && std::isnan(record.arrival_time_s))
            record.arrival_time_s = row.time_s;
        take_all(soil, state.gravity, places_[g], record);
        record.final_thickness_m = row.thickness_m;
        record.passed_area_m2 = row.passed_area_m2;
        if (store && (record.rows.empty() || record.rows.back().time_s < row.time_s))
            record.rows.push_back(row);
    }
}

}  // namespace runout
