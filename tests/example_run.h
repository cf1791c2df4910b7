#pragma once

#include <cmath>

#include "measures/measures.h"
#include "scene/scene.h"
#include "store/store.h"

namespace runout {

/// A small valid scene made by hand, for tests that need one and do not simulate it.
inline Scene example_scene() {
    Scene scene;
    scene.name = "cut-60";
    scene.profile.ground = {{-20, 12}, {-5, 10}, {0, 0}, {40, -1}};
    scene.profile.crest = 1;
    scene.profile.toe = 2;
    scene.profile.toe_chainage_m = 834512.25;
    scene.profile.toe_elevation_m = 41.5;
    scene.profile.origin = "profiles/cut-60.csv";
    scene.source.type = SourceType::c;
    scene.source.outline = {{-1, 2}, {-5, 10}, {-7, 10.25}};
    scene.source.bed = {{-20, 12}, {-7, 10.25}, {-1, 2}, {0, 0}, {40, -1}};
    scene.source.area = 12.5;
    scene.source.front_area = 9.1;
    scene.source.discontinuity_angle = 0.96;
    scene.source.exit_point = {-1, 2};
    scene.source.head = {-7, 10.25};
    scene.source.drop_height = 10.25;
    scene.material = {.density = 1900, .friction_angle = 0.66};
    return scene;
}

/// A settled run in which no two numbers are equal and none is short in binary.
inline RunResult example_result() {
    RunResult result;
    result.status = RunStatus::settled;
    double next = 0.1;
    for (const MeasureField& field : measure_fields()) result.measures.*field.value = next += 1.1;
    result.work = {.particles = 1601,
                   .boundary_particles = 402,
                   .particle_spacing_m = 0.0884,
                   .steps = 2503,
                   .pressure_iterations = 30004,
                   .bed_guard_activations = 5,
                   .highest_density_ratio = 1.021,
                   .simulated_s = 4.7,
                   .wall_s = 2.3,
                   .cpu_s = 4.4,
                   .threads = 2,
                   .peak_memory_mb = 37.25,
                   .spared_share = 0.25};
    result.series = {{0, 0.15, 0.1, 0.2, 300.3, 0.4, 23750.6}, {0.1, 1.2, 1.1, 12.7, 280.3, 7.4, 23750.6}};
    result.deposit = {{834510.25, 43.1, 0.3, 0.4}, {834512.75, 41.5, 1.3, 1.4}, {834515.1, 41.4, 0.9, 1.1}};
    result.envelope = {-3.5,
                       0.7,
                       {0.1, 0.3, 0.7},
                       {1.1, 2.2, 0.0},
                       {0.06, 0.25, 0.0},
                       {230.1, 410.3, 0.0},
                       {0.0, 1.3, std::nan("")},
                       {0.1, 0.2, 0.01},
                       {0.0, 3.3, 0.1}};
    result.phases = {{"pressure", 1.5}, {"friction", 0.6}};
    result.invariants = {{"speed", 0.91, 2.0, 0.31, 1.7}, {"volume", 0.0031, 0.02, 0.47, -0.2}};
    result.snapshots = {{0.25, {1.5F, 2.25F}, {0.5F, 0.1F}, {3.3F, -1.0F}, {0.0F, 7.0F}, {1e5F, 0.3F}},
                        {0.5, {}, {}, {}, {}, {}}};
    result.frames = {
        {{0.1, -7.5, 0.5, 0.25, 0.125, 0.1, 0.02, 3.5, 700.5}, {0, 65535}, {7, 9}, {255, 1}, {0, 254}},
        {{0.2, -7.5, 0.5, 0.25, 0.125, 0.1, 0.02, 3.5, 700.5}, {2, 60000}, {8, 9}, {25, 3}, {1, 200}}};
    result.stages = {{1.1, 2.2, 30.3, 4.4, 5.5}, {1.2, 2.3, 30.4, 4.5, 5.6}};
    return result;
}

/// Error bars from pilots, no number short in binary.
inline Appraisal example_appraisal() {
    return {.accuracy_asked = "5 %",
            .run_out_error_m = 0.61,
            .reach_angle_error_deg = 0.87,
            .error_origin = "pilot",
            .error_note = "2 pilot runs",
            .expected_cpu_s = 4.1,
            .choosing_cpu_s = 0.7};
}

inline PilotRow example_pilot() {
    return {.resolution = 8,
            .lattice_seed = 1,
            .run_out_m = 12.3,
            .reach_angle_deg = 39.1,
            .deposit_height_m = 4.3,
            .particles = 64,
            .steps = 210,
            .pressure_iterations = 1207,
            .cpu_s = 0.031};
}

}  // namespace runout
