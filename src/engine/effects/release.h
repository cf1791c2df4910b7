#pragma once

#include <cstddef>
#include <vector>

#include "engine/effects.h"
#include "engine/particles/bed_line.h"
#include "engine/particles/soil.h"

namespace runout {

/// A staged release: what has been let go, and what is still to come.
class Release {
  public:
    /// `head`: x of the uphill end of the first mass, m.
    Release(StagedRelease release, double head);

    /// To be called when the soil has come to rest. False if nothing more is to come. If a mass is next,
    /// `time` becomes its instant, since nothing happens until then; if a layer is next, it is due at once.
    bool goes_on(double& time);
    /// All soil let go so far is at rest; the next layer is due.
    [[nodiscard]] bool stage_ended() const { return stage_ended_; }
    /// Soil has been added; the next stage begins.
    void begin_stage() { stage_ended_ = false; }

    /// The next mass if its instant has come, else null. Each is given once.
    const LaterMass* mass_due(double time);
    /// Positions of particles, and the elevation of the layer's upper end; both m.
    struct Layer {
        std::vector<Vec2> points;
        double top = 0;
    };
    /// One more layer of a poured heap: a lattice at the uphill end, its lowest particles one spacing above
    /// the highest particle beneath it (Fig. 5 of the paper).
    Layer next_layer(const Soil& soil, const BedLine& bed, double spacing);

  private:
    StagedRelease release_;
    double head_;
    int layers_ = 0;          ///< let go
    std::size_t masses_ = 0;  ///< let go
    bool stage_ended_ = false;
};

/// Particles, m, that fill a mass which is let go later. Where earlier soil lies in its place the whole mass
/// is raised, a spacing at a time, until no particle of it is nearer than 0.7 spacings to that soil.
std::vector<Vec2> place_mass(const Mass& mass, const Soil& soil, double spacing, double smoothing_ratio);

}  // namespace runout
