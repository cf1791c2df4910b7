#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/input_error.h"
#include "core/units.h"
#include "profile/profile.h"

namespace runout {
namespace {

/// More samples than this are a slip of the unit.
constexpr double most_samples = 1e5;

std::string label_of(const SectionLine& line) {
    const std::string label =
        attribute_text(line.map.attributes, {"name", "label", "section", "slope_no", "slope", "id"});
    return label.empty() ? fmt::format("{}", line.feature_id) : label;
}

SectionLine the_line(const LineQuery& query) {
    std::vector<SectionLine> lines = read_section_lines(query);
    if (lines.size() == 1) return std::move(lines.front());
    throw InputError({query.file, 0, "section.line", ""}, fmt::format("has {} lines", lines.size()),
                     "choose one with section.feature_id or section.where");
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

std::vector<Vec2> points_of_line(const MapSection& section, const SectionLine& line) {
    if (line.elevations.empty())
        throw InputError({section.line.file, 0, fmt::format("feature {}", line.feature_id), "LINESTRING"},
                         "has no elevations", "give section.raster to sample, or a three-dimensional line");
    if (section.options.elevation_unit.empty())
        refuse_unconfirmed_unit(section.line.file, line.elevation_unit_m);
    std::vector<double> metres = line.elevations;
    for (double& elevation : metres) elevation *= unit_m(section.options.elevation_unit);
    return profile_points(line.map.chainage_m, metres);
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

/// A number that the layer holds for its features.
double attribute_number(const MapLine& map, const std::string& name) {
    const std::string text = attribute_text(map.attributes, {name});
    double value = std::numeric_limits<double>::quiet_NaN();
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size()
               ? value
               : std::numeric_limits<double>::quiet_NaN();
}

ProfileOptions with_attributes(ProfileOptions options, const MapLine& map) {
    if (std::isnan(options.toe_chainage_m)) options.toe_chainage_m = attribute_number(map, "toe_chainage_m");
    if (std::isnan(options.crest_chainage_m))
        options.crest_chainage_m = attribute_number(map, "crest_chainage_m");
    return options;
}

}  // namespace

Profile read_map_section(const MapSection& section, const ProfileOptions& options) {
    if (!(section.sampling_m >= 0) || !std::isfinite(section.sampling_m))
        throw InputError({"", 0, "section.sampling_m", fmt::format("{:g}", section.sampling_m)},
                         "is not a distance", "give metres, or 0 for half a raster cell");
    SectionLine line = the_line(section.line);
    std::vector<Vec2> points =
        section.raster.empty() ? points_of_line(section, line) : points_on_raster(section, line);
    std::string origin = origin_of(section, line);
    if (section.smoothing_m > 0)
        origin += smoothing_text(section.smoothing_m, smooth_elevations(points, section.smoothing_m));
    const ProfileOptions completed = with_attributes(options, line.map);
    return make_profile({points, {}, origin, {}, std::move(line.map)}, completed);
}

std::vector<SectionFeature> section_features(const LineQuery& query) {
    std::vector<SectionFeature> features;
    for (const SectionLine& line : read_section_lines(query))
        features.push_back({line.feature_id, label_of(line)});
    return features;
}

}  // namespace runout
