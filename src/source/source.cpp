#include "source/source.h"

#include <fmt/format.h>

#include <cmath>

#include "source/shapes.h"
#include "source/source_types.h"
#include "source/spec_check.h"

namespace runout {

Source derive_source(const Profile& profile, const SourceSpec& spec) {
    check_spec(spec);
    return row_of(spec.type).derive(profile, spec);
}

bool is_film(double area, const std::vector<Vec2>& points) {
    constexpr double trace_area = 1e-9;  // over the square of the extent
    return area <= trace_area * std::pow(extent(points), 2);
}

Source source_from(const Region& region, const Profile& profile, const SourceSpec& spec, const Vec2& exit,
                   const Vec2& head) {
    Source source;
    source.type = spec.type;
    source.outline = region.outline();
    source.bed = region.bed_in(profile.ground);
    source.area = region.area();
    if (source.outline.size() < 3 || is_film(source.area, source.outline))
        refuse(spec, "source.type",
               fmt::format("{} has no thickness with these measures", to_string(spec.type)),
               "give measures of one order of size");
    source.front_area = region.area_above(exit, spec.discontinuity_angle);
    source.discontinuity_angle = spec.discontinuity_angle;
    source.exit_point = exit;
    source.head = head;
    source.drop_height = spec.datum == DropDatum::head ? head.y() : exit.y();
    source.datum = spec.datum;
    return source;
}

void require_face(const Profile& profile, const SourceSpec& spec) {
    if (profile.crest < profile.toe && profile.ground[profile.crest].y() > 0) return;
    refuse(spec, "source.type",
           fmt::format("{} needs a face, and the section {} has none", to_string(spec.type), profile.origin),
           "give section.crest_chainage_m and section.toe_chainage_m, or a source of type polygon");
}

GroundPoint on_face(const Profile& profile, const SourceSpec& spec, double elevation, SpecKey key,
                    const std::string& what) {
    const double crest = profile.ground[profile.crest].y();
    // Elevations typed as decimals miss the ends of the face by rounding, above all on map grids.
    if (std::abs(elevation) < 1e-9 * crest) elevation = 0;
    if (std::abs(elevation - crest) < 1e-9 * crest) elevation = crest;
    const auto way = walk(at_vertex(profile.ground, profile.toe), at_vertex(profile.ground, profile.crest));
    if (elevation >= 0 && elevation <= crest)
        if (const auto found = first_at_elevation(profile.ground, way, elevation)) return *found;
    refuse(spec, key,
           fmt::format("puts {} {} m {} the toe", what, figure(std::abs(elevation)),
                       elevation < 0 ? "below" : "above"),
           fmt::format("the face goes from the toe to the crest, {} m above it", figure(crest)));
}

std::string to_string(DropDatum datum) {
    return datum == DropDatum::head ? "head" : "base";
}

}  // namespace runout
