#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "example_run.h"
#include "store/store.h"

namespace runout {
namespace {

using Change = std::pair<const char*, std::function<void(Scene&)>>;

TEST(ScenarioHash, IsSha256InHex) {
    const std::string hash = scenario_hash(example_scene());
    EXPECT_EQ(hash.size(), 64U);
    EXPECT_EQ(hash.find_first_not_of("0123456789abcdef"), std::string::npos);
    EXPECT_EQ(hash, scenario_hash(example_scene()));
}

TEST(ScenarioHash, ChangesWithEverythingThatDeterminesTheResult) {
    const std::vector<Change> changes = {
        {"ground", [](Scene& s) { s.profile.ground[0].y() = std::nextafter(12, 13); }},
        {"points",
         [](Scene& s) {
             s.profile.ground.push_back({50, -1});
         }},
        {"crest", [](Scene& s) { s.profile.crest = 0; }},
        {"toe", [](Scene& s) { s.profile.toe = 3; }},
        {"toe chainage", [](Scene& s) { s.profile.toe_chainage_m += 1; }},
        {"toe elevation", [](Scene& s) { s.profile.toe_elevation_m += 1; }},
        {"direction", [](Scene& s) { s.profile.descends_with_chainage = false; }},
        {"type", [](Scene& s) { s.source.type = SourceType::b; }},
        {"outline", [](Scene& s) { s.source.outline[0].x() -= 0.1; }},
        {"bed", [](Scene& s) { s.source.bed.pop_back(); }},
        {"area", [](Scene& s) { s.source.area += 0.1; }},
        {"front area", [](Scene& s) { s.source.front_area += 0.1; }},
        {"discontinuity", [](Scene& s) { s.source.discontinuity_angle += 0.1; }},
        {"exit", [](Scene& s) { s.source.exit_point.x() += 0.1; }},
        {"head", [](Scene& s) { s.source.head.y() += 0.1; }},
        {"drop height", [](Scene& s) { s.source.drop_height += 0.1; }},
        {"datum", [](Scene& s) { s.source.datum = DropDatum::base; }},
        {"density", [](Scene& s) { s.material.density += 1; }},
        {"friction angle", [](Scene& s) { s.material.friction_angle = std::nextafter(0.66, 1); }},
        {"spacing", [](Scene& s) { s.run.particle_spacing = 0.1; }},
        {"resolution", [](Scene& s) { s.run.resolution = 20; }},
        {"gravity", [](Scene& s) { s.run.gravity = 9.8; }},
        {"courant", [](Scene& s) { s.run.courant = 0.1; }},
        {"smoothing", [](Scene& s) { s.run.smoothing_ratio = 1.2; }},
        {"scheme", [](Scene& s) { s.run.friction = FrictionScheme::explicit_; }},
        {"iterations", [](Scene& s) { s.run.friction_iterations = 7; }},
        {"tolerance", [](Scene& s) { s.run.pressure_tolerance = 1e-3; }},
        {"time limit", [](Scene& s) { s.run.time_limit = 10; }},
        {"sleeping", [](Scene& s) { s.run.sleeping = false; }},
        {"lattice", [](Scene& s) { s.run.lattice_seed = 1; }},
        {"snapshots", [](Scene& s) { s.run.snapshot_times = {0.5}; }},
        {"base friction", [](Scene& s) { s.effects.base_friction = {0.3}; }},
        {"base angle", [](Scene& s) { s.effects.base_friction = {0.4}; }},
        {"release",
         [](Scene& s) {
             s.effects.release = {3, 0.1, 0.2};
         }},
        {"layers",
         [](Scene& s) {
             s.effects.release = {4, 0.1, 0.2};
         }},
        {"layer width",
         [](Scene& s) {
             s.effects.release = {3, 0.3, 0.2};
         }},
        {"layer height",
         [](Scene& s) {
             s.effects.release = {3, 0.1, 0.3};
         }},
        {"front thickness", [](Scene& s) { s.run.front_thickness = 0.1; }},
    };
    std::vector<std::string> hashes = {scenario_hash(example_scene())};
    for (const auto& [what, change] : changes) {
        Scene scene = example_scene();
        change(scene);
        const std::string hash = scenario_hash(scene);
        EXPECT_EQ(std::count(hashes.begin(), hashes.end(), hash), 0) << what;
        hashes.push_back(hash);
    }
}

TEST(ScenarioHash, IgnoresWhatDoesNot) {
    const std::vector<Change> changes = {
        {"name", [](Scene& s) { s.name = "other"; }},
        {"file", [](Scene& s) { s.profile.origin = "/elsewhere/other.csv"; }},
        {"threads", [](Scene& s) { s.run.threads = 2; }},
        {"assumed", [](Scene& s) { s.assumed.emplace_back("said in words only"); }},
        {"sign of zero", [](Scene& s) { s.profile.ground[2].y() = -0.0; }},
    };
    for (const auto& [what, change] : changes) {
        Scene scene = example_scene();
        change(scene);
        EXPECT_EQ(scenario_hash(scene), scenario_hash(example_scene())) << what;
    }
}

}  // namespace
}  // namespace runout
