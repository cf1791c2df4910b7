#pragma once

#include <cstddef>
#include <vector>

#include "engine/effects/effects.h"
#include "engine/particles/bed_line.h"
#include "engine/particles/soil.h"

namespace runout {

/// What of a staged release has been let go, and what is still to come.
class Release {
  public:
    /// `head`: x of the uphill end of the first mass, m.
    Release(StagedRelease release, double head);

    /// Soil has come to rest. False if no more is to come; else either the next mass, at whose instant `time`
    /// then stands, since nothing happens until then; or the next layer, which is due at once.
    bool goes_on(double& time);
    /// All soil let go so far is at rest; the next layer is due.
    [[nodiscard]] bool stage_ended() const { return stage_ended_; }
    /// Soil has been added; what was at rest is taken as at rest.
    void begin_stage() { stage_ended_ = false; }

    /// The next mass if its instant has come, else null.
    const LaterMass* mass_due(double time);
    /// A lattice of particles, m, and its upper end.
    struct Layer {
        std::vector<Vec2> points;
        double top = 0;
    };
    /// One more layer of a poured heap: a lattice at the uphill end, its lowest row one spacing above the
    /// highest particle beneath it (Fig. 5 of the paper).
    Layer next_layer(const Soil& soil, const BedLine& bed, double spacing);

  private:
    StagedRelease release_;
    double head_;
    int layers_ = 0;          ///< let go
    std::size_t masses_ = 0;  ///< let go
    bool stage_ended_ = false;
};

/// Particles that fill a mass which is let go later. Where soil that came down before lies in its place, the
/// whole mass is let go from above it: it is raised by spacings until no two particles are nearer than 0.7 of
/// one.
std::vector<Vec2> place_mass(const Mass& mass, const Soil& soil, double spacing, double smoothing_ratio);

}  // namespace runout
