#include "hard/hard_scenes.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <initializer_list>

#include "core/units.h"
#include "scenes.h"
#include "stress/hillside.h"

namespace runout {
namespace {

using Scenes = std::vector<HardScene>;

double code(SourceKind kind) {
    return static_cast<double>(kind) + 0.5;
}
double code(HillsideShape shape) {
    return static_cast<double>(shape) + 0.5;
}

void add(Scenes& scenes, bool quick, const std::string& name, const StressPoint& point) {
    scenes.push_back({name, quick, [=] { return stress_scene(point, name); }});
}

template <class Change>
void add(Scenes& scenes, bool quick, const std::string& name, const Change& change) {
    StressPoint p = plain_hard_point();
    change(p);
    add(scenes, quick, name, p);
}

void add_slopes(Scenes& scenes) {
    for (const int angle : {20, 35, 50, 65, 80, 90}) {
        add(scenes, angle == 50 || angle == 90, fmt::format("slope_{}", angle), [=](StressPoint& p) {
            p.source_kind = code(SourceKind::b);
            p.slope_angle_deg = angle;
            if (angle == 90) p.source_kind = code(SourceKind::a);
            if (angle == 80) p.drop_height_ratio = 8;
            // On a face at repose a wedge stands; let it go on a weak base.
            if (angle < 40) p.friction_angle_deg = 15;
        });
    }
    for (const int angle : {30, 45, 60, 75, 89}) {
        add(scenes, angle == 60, fmt::format("concave_toe_{}", angle), [=](StressPoint& p) {
            p.hillside_shape = code(HillsideShape::concave_toe);
            p.slope_angle_deg = angle;
            if (angle < 40) p.friction_angle_deg = 20;
        });
    }
    for (const auto shape : {HillsideShape::retaining_wall, HillsideShape::convex_crest, HillsideShape::berms,
                             HillsideShape::notch, HillsideShape::steps}) {
        add(scenes, shape == HillsideShape::notch || shape == HillsideShape::steps, to_string(shape),
            [=](StressPoint& p) {
                p.source_kind = code(SourceKind::c);
                p.hillside_shape = code(shape);
                if (shape == HillsideShape::berms) p.drop_height_ratio = 8;
            });
    }
}

void add_impacts(Scenes& scenes) {
    add(scenes, false, "fall_50", [](StressPoint& p) {
        p.source_kind = code(SourceKind::falling_block);
        p.drop_height_ratio = 50;
    });
    add(scenes, true, "fall_10", [](StressPoint& p) {
        p.source_kind = code(SourceKind::falling_block);
        p.drop_height_ratio = 10;
    });
    add(scenes, false, "box_drop_50", [](StressPoint& p) {
        p.slope_angle_deg = 70;
        p.drop_height_ratio = 50;
    });
    add(scenes, true, "column_50", [](StressPoint& p) {
        p.source_kind = code(SourceKind::column);
        p.aspect_ratio = 50;
    });
    add(scenes, true, "sheet_50", [](StressPoint& p) {
        p.source_kind = code(SourceKind::sheet);
        p.aspect_ratio = 50;
        p.drop_height_ratio = 10;
        p.resolution = 20;
    });
    add(scenes, true, "sliver", [](StressPoint& p) {
        p.source_kind = code(SourceKind::sliver);
        p.drop_height_ratio = 20;
    });
    for (const int particles : {4, 9, 25}) {
        scenes.push_back({fmt::format("particles_{}", particles), true, [=] {
                              StressPoint p = plain_hard_point();
                              p.aspect_ratio = 1;
                              Scene scene = stress_scene(p, "few");
                              scene.run.particle_spacing = p.size_m / std::sqrt(particles);
                              return scene;
                          }});
    }
    scenes.push_back({"landing_on_deposit", true, [] {
                          StressPoint p = plain_hard_point();
                          p.source_kind = code(SourceKind::b);
                          Scene scene = stress_scene(p, "landing");
                          scene.effects.release = StagedRelease{3, 2.0, 1.5};
                          return scene;
                      }});
}

void add_frictions(Scenes& scenes) {
    for (const int angle : {5, 50, 60}) {
        add(scenes, angle == 5 || angle == 60, fmt::format("friction_{}", angle),
            [=](StressPoint& p) { p.friction_angle_deg = angle; });
        add(scenes, false, fmt::format("friction_{}_fall_20", angle), [=](StressPoint& p) {
            p.friction_angle_deg = angle;
            p.source_kind = code(SourceKind::falling_block);
            p.drop_height_ratio = 20;
        });
    }
    for (const int percent : {10, 30, 60, 100}) {
        add(scenes, percent == 30, fmt::format("base_friction_{}_percent", percent),
            [=](StressPoint& p) { p.base_friction_share = percent / 100.0 - 1e-9; });
    }
    // Repose of phi = 30 deg is 26.57 deg.
    for (const double angle : {25.5, 26.2, 27.0, 28.0}) {
        scenes.push_back({fmt::format("heap_{}_of_26_6_deg", static_cast<int>(10 * angle)), angle == 25.5,
                          [=] { return scenes::heap(angle, 5.0, 30.0, 0.35); }});
    }
}

void add_frames(Scenes& scenes) {
    add(scenes, true, "offset_1e6", [](StressPoint& p) { p.offset_m = 1e6; });
    add(scenes, true, "reversed", [](StressPoint& p) { p.reversed = 1.5; });
    add(scenes, true, "a_thousand_times_smaller", [](StressPoint& p) { p.size_m *= 1e-3; });
    add(scenes, true, "a_thousand_times_gravity", [](StressPoint& p) { p.gravity_m_s2 *= 1e3; });
    add(scenes, true, "run_out_rises", [](StressPoint& p) { p.run_out_slope_share = -1; });
    add(scenes, false, "run_out_falls", [](StressPoint& p) { p.run_out_slope_share = 0.7; });
}

void add_random(Scenes& scenes, std::uint64_t seed, std::initializer_list<std::size_t> numbers) {
    const std::vector<StressPoint> points = stress_points(stress_axes(), 1000, seed);
    for (const std::size_t k : numbers) {
        const StressPoint& point = points[k];
        scenes.push_back({fmt::format("random_{}_of_seed_{}", k, seed), true,
                          [=] { return stress_scene(point, "random"); }});
    }
}

/// Those of `runout stress --scenes 1000` that once did not end as they should.
void add_random(Scenes& scenes) {
    // A needle that starts crowded; grains scattered over a rising bed; grains alone on a slope just steeper
    // than repose; a film just below it; pressure that decays until it is no number; grains on a base of 1
    // deg.
    add_random(scenes, 1, {751, 707, 737, 515, 422, 911});
    add_random(scenes, 1, {183, 326});  // piles that gave way after they had been judged to rest
    add_random(scenes, 1, {308});       // films that crept on a base of a few degrees
    add_random(scenes, 2, {249, 419});
    add_random(scenes, 1, {365});  // a thin layer that kept jumping after its fall
    add_random(scenes, 2, {44});   // grains alone that the wall threw out
    add_random(scenes, 2, {360});  // grains on steps of one particle that crept after their rest
    add_random(scenes, 3, {804});  // a jet from the foot of a wall
}

// Open, see docs/stability.md: grains of its splash are faster than the fall and pass the end of the section.
constexpr const char* leaves_at_size = "friction_5_fall_20";

/// Whether the scene says by itself how large its particles are.
bool has_own_spacing(const Scene& scene) {
    return scene.run.particle_spacing > 0;
}

}  // namespace

StressPoint plain_hard_point() {
    StressPoint p;
    p.slope_angle_deg = 60;
    p.friction_angle_deg = 35;
    p.base_friction_share = 3;
    p.drop_height_ratio = 4;
    p.aspect_ratio = 2;
    p.base_angle_share = 0.5;
    p.scarp_angle_share = 0.6;
    p.detail_ratio = 0.5;
    p.size_m = 5;
    p.gravity_m_s2 = 9.81;
    p.resolution = 10;
    return p;
}

std::vector<HardScene> hard_scenes() {
    Scenes scenes;
    add_slopes(scenes);
    add_impacts(scenes);
    add_frictions(scenes);
    add_frames(scenes);
    add_random(scenes);
    return scenes;
}

std::vector<HardScene> hard_scenes_at(double resolution, bool quick_only) {
    Scenes scenes;
    for (const HardScene& scene : hard_scenes()) {
        if ((quick_only && !scene.quick) || has_own_spacing(scene.make())) continue;
        if (scene.name == leaves_at_size) continue;
        scenes.push_back({fmt::format("{}_at_{:g}", scene.name, resolution), scene.quick, [=] {
                              Scene finer = scene.make();
                              finer.run.resolution = resolution;
                              return finer;
                          }});
    }
    return scenes;
}

}  // namespace runout
