// Soil that comes too near the bed line is put back; see docs/engine.md.

#include <algorithm>

#include "engine/simulation.h"
#include "engine/threads/node_array.h"
#include "engine/threads/row_passes.h"

namespace runout {
namespace {

constexpr double harmless_depth = 0.05;  // spacings; what presses no further beyond the bed is no defect

}  // namespace

BedLine::Nearest Simulation::nearest_bed(int i) const {
    const int boundary = neighbours_.nearest_boundary[i];
    return boundary < 0 ? bed_.below(soil_.x[i], soil_.y[i])
                        : bed_.nearest({soil_.x[i], soil_.y[i]}, wall_.segment[boundary], 8);
}

/// How near the bed line soil may come, m. Soil in company as near as pressure lets it; a grain alone, which
/// no pressure holds, as near as the lowest row of a lattice lies, or it would be shot out where others join
/// it.
double Simulation::clearance(int i) const {
    return 0.5 * (1.0 - neighbours_.company[i]) * discretisation_.spacing;
}

/// Finds how far all soil is from as near to the bed line as it may come; nothing for what rests. What the
/// bed gave in the last step is forgotten.
void Simulation::find_bed_gap() {
    fit(bed_gap_, soil_.count);
    fit(meets_bed_, neighbours_.chunks.count());
    const bool all_awake = neighbours_.resting.empty();
    for_each_chunk(neighbours_.chunks, [&](int chunk) {
        double least = 0.0;
        for_each_soil(neighbours_, chunk, [&](int i) {
            bed_gap_[i] = 0.0;
            if (!all_awake && neighbours_.rests(i)) return;
            soil_.contact_x[i] = soil_.contact_y[i] = 0.0;
            bed_gap_[i] = nearest_bed(i).distance - clearance(i);
            least = std::min(least, bed_gap_[i]);
        });
        meets_bed_[chunk] = least < 0.0 ? 1 : 0;
    });
}

/// No particle nearer the bed line than it may come: it is put back, in company by at most half a spacing,
/// and its velocity into the bed ends. Says how many were driven in and how deep the deepest still is.
StepFacts Simulation::guard_wall(double dt) {
    StepFacts facts;
    find_bed_gap();
    for (int chunk = 0; chunk < neighbours_.chunks.count(); ++chunk) {
        if (meets_bed_[chunk] == 0) continue;
        for_each_soil(neighbours_, chunk, [&](int i) {
            if (bed_gap_[i] < 0.0) put_back(i, dt, facts);
        });
    }
    work_.wall_guard_activations += facts.driven_in;
    return facts;
}

void Simulation::put_back(int i, double dt, StepFacts& facts) {
    const BedLine::Nearest near = nearest_bed(i);
    const bool in_company = neighbours_.company[i] == 1.0F;
    // A grain alone is carried here, and may have come a whole spacing in the step.
    const double depth = -bed_gap_[i];
    const double back = in_company ? std::min(depth, 0.5 * discretisation_.spacing) : depth;
    const Vec2 taken = push_back(i, back, near.normal, dt);
    if (barrier_) barrier_->add_guard_impulse(near.segment, discretisation_.mass() * taken);
    // Soil under pressure should have been kept out by it; what nothing presses simply lands. That is the
    // pressure of this step: what is carried on outlasts it.
    const bool pressed = soil_.pressure[i] > 0.0 && pressure_.node_pressure()[i] > 0.0;
    if (back > harmless_depth * discretisation_.spacing && in_company && pressed) ++facts.driven_in;
    if (depth - back <= facts.greatest_depth) return;
    facts.greatest_depth = depth - back;
    facts.depth_x = soil_.x[i];
}

/// Returns the change of velocity that the bed took.
Vec2 Simulation::push_back(int i, double distance, const Vec2& normal, double dt) {
    const Vec2 v{soil_.vx[i], soil_.vy[i]};
    const double inward = std::max(0.0, -v.dot(normal));
    const Vec2 slip = v - v.dot(normal) * normal;
    const double speed = slip.norm();
    const double strength = base_strength_ratio(material_, effects_, soil_.x[i]);
    const double kept = speed > 0.0 ? std::max(0.0, 1.0 - strength * inward / speed) : 0.0;
    const Vec2 left = kept * slip + std::max(0.0, v.dot(normal)) * normal;
    const double push = std::min(inward / dt, run_.gravity);
    soil_.contact_x[i] = push * normal.x();
    soil_.contact_y[i] = push * normal.y();
    // Since it met the bed it has slid too far, or a grain would creep down a slope that holds it.
    const double since = inward * dt > distance ? distance / inward : dt;
    const Vec2 moved = distance * normal - (1.0 - kept) * since * slip;
    soil_.x[i] += moved.x();
    soil_.y[i] += moved.y();
    soil_.vx[i] = left.x();
    soil_.vy[i] = left.y();
    guard_work_ +=
        discretisation_.mass() * (0.5 * (v.squaredNorm() - left.squaredNorm()) - run_.gravity * moved.y());
    return v - left;
}

}  // namespace runout
