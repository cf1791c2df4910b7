#pragma once

#include <cstddef>
#include <vector>

#include "engine/simulation.h"
#include "measures/measures.h"

namespace runout {

/// Keeps pictures of the moving mass at equal steps of simulated time, for people to look at. Since nobody
/// knows when a run ends, the step doubles, and every second picture goes, each time there are more than
/// `most`; a run so ends with between half of `most` and `most` of them, and two at least. Of many particles
/// a part is kept, always the same, spread evenly.
class FrameRecorder {
  public:
    /// `most`: pictures; 0 keeps none. `interval`: between the first of them, s.
    FrameRecorder(int most, double interval) : most_(static_cast<std::size_t>(most)), interval_(interval) {}

    /// Takes a picture if one is due; `last` takes it anyway.
    void sample(const Simulation& simulation, bool last = false);

    [[nodiscard]] std::vector<Frame> frames() const;

  private:
    /// Positions and speeds as they were; coded when the run has ended and their ranges are known.
    struct Picture {
        double time_s = 0;
        std::vector<float> x_m, y_m, speed_m_s, pressure_pa;
    };

    void take(const StateView& state);
    void thin_out();

    std::size_t most_;
    double interval_;
    double due_ = 0;
    std::size_t particles_at_release_ = 0;
    std::vector<Picture> pictures_;
};

/// Whether particle number `id` is one of those that frames show, out of `particles`: all up to
/// frame_particles, else about that many. Numbers follow the lattice row by row; multiples of the golden
/// ratio leave neither gaps nor stripes in it.
bool is_shown(int id, std::size_t particles);

/// Most particles that a frame shows (a staged release may exceed it as it grows).
constexpr std::size_t frame_particles = 4000;

}  // namespace runout
