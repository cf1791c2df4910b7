#include "engine/effects/bed_guard.h"

#include <algorithm>

#include "engine/pairs/row_passes.h"
#include "engine/threads/node_array.h"

namespace runout {
namespace {

constexpr double harmless_depth = 0.05;  // spacings; a particle that is driven in by less is not counted
constexpr int segments_near = 8;

BedLine::Nearest nearest_bed(const ParticleSystem& particles, int i) {
    const Soil& soil = particles.soil;
    const Wall& wall = particles.wall;
    const int wall_index = particles.neighbours.nearest_boundary[i];
    return wall_index < 0
               ? wall.bed_line.below(soil.x[i], soil.y[i])
               : wall.bed_line.nearest({soil.x[i], soil.y[i]}, wall.segment[wall_index], segments_near);
}

}  // namespace

/// How near soil may come to the bed line, m. Soil in company: to the line, since pressure keeps it off. A
/// lone grain: to half a spacing, where the lowest particles of a lattice lie. Nearer, it would be shot out
/// when others join it.
double BedGuard::clearance(const Neighbours& n, int i) const {
    return 0.5 * (1.0 - n.company[i]) * discretisation_.spacing;
}

/// Finds gap_ for all soil (0 for soil that sleeps), and sets to 0 the push of the bed line in the last step.
void BedGuard::find_gaps(ParticleSystem& particles) {
    const Neighbours& n = particles.neighbours;
    Soil& soil = particles.soil;
    fit(gap_, soil.count);
    fit(some_inside_, n.chunks.count());
    const bool all_awake = n.asleep.empty();
    for_each_chunk(n.chunks, [&](int chunk) {
        double least = 0.0;
        for_each_soil(n, chunk, [&](int i) {
            gap_[i] = 0.0;
            if (!all_awake && n.is_asleep(i)) return;
            soil.contact_x[i] = soil.contact_y[i] = 0.0;
            gap_[i] = nearest_bed(particles, i).distance - clearance(n, i);
            least = std::min(least, gap_[i]);
        });
        some_inside_[chunk] = least < 0.0 ? 1 : 0;
    });
}

StepFacts BedGuard::put_back(ParticleSystem& particles, const std::vector<double>& node_pressure, double dt,
                             EffectSet& effects, WorkLedger& ledger) {
    const Neighbours& n = particles.neighbours;
    const Step step{particles, node_pressure, dt, effects, ledger};
    StepFacts facts;
    find_gaps(particles);
    for (int chunk = 0; chunk < n.chunks.count(); ++chunk) {
        if (some_inside_[chunk] == 0) continue;
        for_each_soil(n, chunk, [&](int i) {
            if (gap_[i] < 0.0) put_back(i, step, facts);
        });
    }
    ledger.counts.bed_guard_activations += facts.driven_in;
    return facts;
}

void BedGuard::put_back(int i, const Step& step, StepFacts& facts) {
    const Soil& soil = step.particles.soil;
    const BedLine::Nearest near = nearest_bed(step.particles, i);
    const bool in_company = step.particles.neighbours.company[i] == 1.0F;
    // A lone grain may have gone a whole spacing in the step, and is put back all the way.
    const double depth = -gap_[i];
    const double back = in_company ? std::min(depth, 0.5 * discretisation_.spacing) : depth;
    const Vec2 taken = push_back(i, back, near.normal, step);
    step.effects.add_guard_impulse(near.segment, discretisation_.mass() * taken);
    // Soil that nothing presses simply lands. Soil under pressure should have been kept out by it, and counts
    // as driven in. Asked for is the pressure of this step too, since the one that is carried on lasts
    // longer.
    const bool pressed = soil.pressure[i] > 0.0 && step.node_pressure[i] > 0.0;
    if (back > harmless_depth * discretisation_.spacing && in_company && pressed) ++facts.driven_in;
    if (depth - back <= facts.greatest_depth) return;
    facts.greatest_depth = depth - back;
    facts.depth_x = soil.x[i];
}

/// Moves particle `i` out by `distance`. Returns the velocity that the bed took from it, m/s.
Vec2 BedGuard::push_back(int i, double distance, const Vec2& normal, const Step& step) {
    Soil& soil = step.particles.soil;
    const double dt = step.dt;
    const Vec2 v{soil.vx[i], soil.vy[i]};
    const double inward = std::max(0.0, -v.dot(normal));
    const Vec2 slip = v - v.dot(normal) * normal;
    const double speed = slip.norm();
    const double strength = step.effects.base_strength(soil.x[i]);
    const double kept = speed > 0.0 ? std::max(0.0, 1.0 - strength * inward / speed) : 0.0;
    const Vec2 left = kept * slip + std::max(0.0, v.dot(normal)) * normal;
    const double push = std::min(inward / dt, gravity_);
    soil.contact_x[i] = push * normal.x();
    soil.contact_y[i] = push * normal.y();
    // Friction also takes back the way that it slid since it met the bed. Else a grain would creep down a
    // slope that holds it.
    const double since = inward * dt > distance ? distance / inward : dt;
    const Vec2 moved = distance * normal - (1.0 - kept) * since * slip;
    soil.x[i] += moved.x();
    soil.y[i] += moved.y();
    soil.vx[i] = left.x();
    soil.vy[i] = left.y();
    step.ledger.guard +=
        discretisation_.mass() * (0.5 * (v.squaredNorm() - left.squaredNorm()) - gravity_ * moved.y());
    return v - left;
}

}  // namespace runout
