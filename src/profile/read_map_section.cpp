#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/input_error.h"
#include "core/units.h"
#include "profile/check_elevations.h"
#include "profile/line_attributes.h"
#include "profile/line_elevations.h"
#include "profile/profile.h"

namespace runout {
namespace {

/// More samples than this are a slip of the unit.
constexpr double most_samples = 1e5;

/// Empty where no attribute names the line.
std::string label_of(const MapLine& map) {
    return attribute_text(map.attributes, {"name", "label", "section", "slope_no", "slope", "id"});
}

/// The line with a point at every sample.
MapLine sampled(const MapLine& line, double spacing_m, const MapSection& section) {
    const double length = line.chainage_m.back();
    const double steps = std::max(1.0, std::ceil(length / spacing_m - 1e-9));
    if (steps > most_samples)
        throw InputError({section.line.file, 0, "section.sampling_m", fmt::format("{:g}", spacing_m)},
                         fmt::format("makes {:.3g} samples of a line of {:.4g} m", steps, length),
                         fmt::format("give {:.3g} m or more", length / most_samples));
    MapLine samples{line.crs, {}, {}, {}};
    for (int i = 0; i <= static_cast<int>(steps); ++i) {
        const double chainage = length * i / steps;
        samples.chainage_m.push_back(chainage);
        samples.points.push_back(point_at(line, chainage));
    }
    return samples;
}

std::vector<Vec2> profile_points(const std::vector<double>& chainages,
                                 const std::vector<double>& elevations) {
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < chainages.size(); ++i) points.emplace_back(chainages[i], elevations[i]);
    return points;
}

std::vector<Vec2> points_on_raster(const MapSection& section, const SectionLine& line) {
    const ElevationRaster raster(section.raster, section.options);
    const double spacing = section.sampling_m > 0 ? section.sampling_m : raster.cell_size_m(line.map) / 2;
    const MapLine samples = sampled(line.map, spacing, section);
    return profile_points(samples.chainage_m, raster.elevations(samples));
}

std::string smoothing_text(double window_m, const Smoothing& told) {
    return fmt::format(
        ", smoothed over {:g} m (elevations moved by up to {:.3g} m at chainage {:.4g}, {:.2g} m rms; "
        "steepest part "
        "{:.1f} deg before, {:.1f} deg after)",
        window_m, told.greatest_change_m, told.greatest_change_chainage_m, told.rms_change_m,
        degrees(told.steepest_before), degrees(told.steepest_after));
}

std::string origin_of(const MapSection& section, const SectionLine& line) {
    const std::string where =
        fmt::format("{}, layer {}, feature {}", section.line.file, line.layer, line.feature_id);
    return section.raster.empty() ? where : fmt::format("{} along {}", section.raster, where);
}

}  // namespace

Profile read_map_section(const MapSection& section, const ProfileOptions& options) {
    if (!(section.sampling_m >= 0) || !std::isfinite(section.sampling_m))
        throw InputError({"", 0, "section.sampling_m", fmt::format("{:g}", section.sampling_m)},
                         "is not a distance", "give metres, or 0 for half a raster cell");
    SectionLine line = read_section_line(section.line);
    SectionPoints read{.origin = origin_of(section, line)};
    read.points = section.raster.empty() ? line_elevations(section, line) : points_on_raster(section, line);
    check_elevations(read);
    if (section.smoothing_m > 0)
        read.origin +=
            smoothing_text(section.smoothing_m, smooth_elevations(read.points, section.smoothing_m));
    const ProfileOptions completed = with_attributes(options, line, section.line.file);
    read.map_line = std::move(line.map);
    return make_profile(read, completed);
}

std::vector<SectionFeature> section_features(const LineQuery& query) {
    std::vector<SectionFeature> features;
    for (LineFeature& feature : list_section_lines(query)) {
        const std::string label = label_of(feature.drawn);
        const std::string name = label.empty() ? fmt::format("{}", feature.feature_id) : label;
        features.push_back({std::move(feature), name, !label.empty()});
    }
    return features;
}

}  // namespace runout
