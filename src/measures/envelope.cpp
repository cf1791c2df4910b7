#include "measures/envelope.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace runout {
namespace {

constexpr double never = std::numeric_limits<double>::quiet_NaN();

/// Particles at or beyond a node, which may lie before or beyond all soil.
long beyond(const ThicknessField& soil, long node) {
    if (soil.nodes() == 0) return 0;
    const long place = node - soil.first_node();
    if (place >= static_cast<long>(soil.nodes())) return 0;
    return soil.beyond_node(static_cast<std::size_t>(std::max(0L, place)));
}

}  // namespace

EnvelopeRecorder::EnvelopeRecorder(double density, const ReachRecorder& start)
    : density_(density), step_(start.soil().node_step()), start_first_node_(start.soil().first_node()) {
    for (std::size_t i = 0; i < start.soil().nodes(); ++i)
        beyond_at_start_.push_back(start.soil().beyond_node(i));
}

long EnvelopeRecorder::beyond_at_start(long node) const {
    if (beyond_at_start_.empty()) return 0;
    const long place = node - start_first_node_;
    if (place >= static_cast<long>(beyond_at_start_.size())) return 0;
    return beyond_at_start_[static_cast<std::size_t>(std::max(0L, place))];
}

void EnvelopeRecorder::make_room(long first, long last) {
    Node fresh{.arrival = never};
    if (nodes_.empty()) first_node_ = first;
    if (first < first_node_) {  // uphill, where the front has been beyond from when it was beyond the first
        fresh.arrival = nodes_.front().arrival;
        nodes_.insert(nodes_.begin(), static_cast<std::size_t>(first_node_ - first), fresh);
        first_node_ = first;
        fresh.arrival = never;
    }
    const auto wanted = static_cast<std::size_t>(last - first_node_ + 1);
    if (wanted > nodes_.size()) nodes_.resize(wanted, fresh);
}

void EnvelopeRecorder::look(const ReachRecorder& reach, const StateView& state) {
    const ThicknessField& soil = reach.soil();
    gravity_ = state.gravity;
    if (soil.nodes() == 0) return;
    const long first = soil.first_node();
    make_room(first, first + static_cast<long>(soil.nodes()) - 1);
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
        Node& node = nodes_[k];
        const long number = first_node_ + static_cast<long>(k);
        const bool is_there = number >= first && number < first + static_cast<long>(soil.nodes());
        const SoilColumn column =
            is_there ? soil.node(static_cast<std::size_t>(number - first)) : SoilColumn{};
        node.final_thickness = column.thickness;
        node.passed =
            static_cast<double>(beyond(soil, number) - beyond_at_start(number)) * soil.particle_area();
        node.thickness = std::max(node.thickness, column.thickness);
        if (std::isnan(node.arrival) && reach.farthest_front() >= static_cast<double>(number) * step_)
            node.arrival = state.time;
        if (column.thickness < soil.rule().threshold) continue;  // grains that fly ahead say nothing
        const double speed_2 = column.velocity.squaredNorm();
        node.speed_2 = std::max(node.speed_2, speed_2);
        node.flux = std::max(node.flux, density_ * speed_2 * column.thickness);
    }
}

Envelope EnvelopeRecorder::envelope() const {
    Envelope all;
    all.first_m = static_cast<double>(first_node_) * step_;
    all.step_m = step_;
    for (const Node& node : nodes_) {
        all.greatest_thickness_m.push_back(node.thickness);
        all.greatest_speed_m_s.push_back(std::sqrt(node.speed_2));
        all.greatest_kinetic_head_m.push_back(0.5 * node.speed_2 / gravity_);
        all.greatest_momentum_flux_n_m.push_back(node.flux);
        all.arrival_time_s.push_back(node.arrival);
        all.final_thickness_m.push_back(node.final_thickness);
        all.passed_area_m2.push_back(node.passed);
    }
    return all;
}

}  // namespace runout
