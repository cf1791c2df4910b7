#include "scene/length_check.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace runout {
namespace {

struct Length {
    const char* key;
    double metres;
    double least, most;  ///< over sqrt(S)
};

std::vector<Length> lengths_of(const CaseSpec& spec) {
    const Effects& effects = spec.effects;
    // A front as thick as half of the mass lies where nobody would look for one.
    std::vector<Length> lengths = {{"run.front_thickness_m", spec.run.front_thickness, 0, 0.5}};
    if (spec.run.front_window > 0) lengths.push_back({"run.front_window_m", spec.run.front_window, 0.02, 2});
    if (effects.side_walls)
        lengths.push_back({"effects.side_walls.width_m", effects.side_walls->width, 0.1, 1e6});
    if (effects.erodible_bed)
        lengths.push_back({"effects.erodible_bed.depth_m", effects.erodible_bed->depth, 0, 100});
    if (effects.release && effects.release->layers > 0) {
        lengths.push_back({"effects.release.layer_width_m", effects.release->layer_width, 0.01, 100});
        lengths.push_back({"effects.release.layer_height_m", effects.release->layer_height, 0.01, 100});
    }
    return lengths;
}

}  // namespace

void check_lengths(const CaseSpec& spec, double area) {
    const double across = std::sqrt(area);
    for (const auto& [key, metres, least, most] : lengths_of(spec))
        if (!(metres >= least * across && metres <= most * across))
            throw InputError(spec.place(key), "is out of proportion to the mass",
                             fmt::format("valid: {:.3g} to {:.3g} m, {:g} to {:g} times sqrt(S)",
                                         least * across, most * across, least, most));
}

}  // namespace runout
