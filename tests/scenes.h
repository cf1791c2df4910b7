#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/units.h"
#include "scene/scene.h"

namespace runout::scenes {

/// Scene of a free polygon on a section given by its points, both in section coordinates.
inline Scene polygon(const std::vector<Vec2>& section, const std::vector<Vec2>& outline,
                     double friction_angle_deg, double spacing) {
    Scene scene;
    std::vector<int> lines(section.size(), 0);
    scene.profile = make_profile({section, lines, "test"}, {});
    SourceSpec spec;
    spec.type = SourceType::polygon;
    spec.points = section_points(outline);
    scene.source = derive_source(scene.profile, spec);
    scene.material.density = 2079.5;
    scene.material.friction_angle = radians(friction_angle_deg);
    scene.run.particle_spacing = spacing;
    scene.run.threads = 1;
    return scene;
}

/// The aluminium-bar column of Bui et al. 2008 and Nguyen et al. 2016: 0.2 x 0.1 m against a wall.
inline Scene aluminium_column(double friction_angle_deg, double spacing) {
    Scene scene = polygon({{0, 0.2}, {0, 0}, {1.2, 0}}, {{0, 0}, {0.2, 0}, {0.2, 0.1}, {0, 0.1}},
                          friction_angle_deg, spacing);
    scene.run.front_thickness = 0.004;
    return scene;
}

/// A block of soil, `height` high and 0.1 m wide, that is let go 0.12 m above the column's foot after `time`.
inline LaterMass mass_above_column(const Scene& column, double time, double height) {
    return {time,
            {.outline = {{0.0, 0.12}, {0.1, 0.12}, {0.1, 0.12 + height}, {0.0, 0.12 + height}},
             .ground = column.source.bed,
             .area = 0.1 * height}};
}

/// Slab of the material, `rows` x `columns` particles, on a rough plane of the given inclination.
inline Scene slab(double slope_deg, int columns, int rows, double friction_angle_deg, double spacing) {
    const double t = radians(slope_deg);
    const Vec2 down{std::cos(t), -std::sin(t)};
    const Vec2 up{std::sin(t), std::cos(t)};
    const double length = columns * spacing;
    const double height = rows * spacing;
    // The plane's upper end is the origin; the slab starts a third of its length below.
    const Vec2 from = length / 3.0 * down;
    const std::vector<Vec2> outline{from, from + length * down, from + length * down + height * up,
                                    from + height * up};
    return polygon({{0, 0}, 3.0 * length * down}, outline, friction_angle_deg, spacing);
}

/// One-sided heap of the given inclination against a wall, foot towards +x.
inline Scene heap(double slope_deg, double height, double friction_angle_deg, double spacing) {
    const double length = height / std::tan(radians(slope_deg));
    return polygon({{0, 2 * height}, {0, 0}, {2 * length, 0}}, {{0, 0}, {length, 0}, {0, height}},
                   friction_angle_deg, spacing);
}

/// Box of the material between two walls, filled to `height`.
inline Scene silo(double width, double height, double friction_angle_deg, double spacing) {
    return polygon({{0, 2 * height}, {0, 0}, {width, 0}, {width, 1.5 * height}},
                   {{0, 0}, {width, 0}, {width, height}, {0, height}}, friction_angle_deg, spacing);
}

/// Box of Bryant et al. 2015: 96 x 45 mm on a face of 45 or 70 deg, head at `drop` above the toe.
inline Scene box(double slope_deg, double drop, double spacing) {
    const double t = radians(slope_deg);
    const double crest = 0.5;
    Scene scene;
    const std::vector<Vec2> section{
        {-crest / std::tan(t) - 0.3, crest}, {-crest / std::tan(t), crest}, {0, 0}, {1.5, 0}};
    scene.profile = make_profile({section, std::vector<int>(4, 0), "test"}, {});
    SourceSpec spec;
    spec.type = SourceType::rectangle;
    spec.length = 0.096;
    spec.thickness = 0.045;
    spec.drop_height = drop;
    scene.source = derive_source(scene.profile, spec);
    scene.material.density = 1600;
    scene.material.friction_angle = radians(38.0);
    scene.run.particle_spacing = spacing;
    scene.run.front_thickness = 0.003;
    scene.run.threads = 1;
    return scene;
}

}  // namespace runout::scenes
