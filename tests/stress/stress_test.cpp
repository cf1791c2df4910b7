// The random scenes: spread as they should be, the same for the same seed, and most of them valid input.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <set>

#include "core/input_error.h"
#include "engine/friction/yield_strength.h"
#include "profile/profile.h"
#include "report/text/stress_table.h"
#include "scene/case_file.h"
#include "store/store.h"
#include "store_fixture.h"
#include "stress/hillside.h"
#include "stress/run_stress.h"
#include "stress/stress_case.h"
#include "stress/stress_scene.h"

namespace runout {
namespace {

TEST(HillsideTest, EveryShapeIsAValidSectionWithItsToeAtTheOrigin) {
    for (int shape = 0; shape < static_cast<int>(HillsideShape::count); ++shape) {
        for (const double angle : {0.4, 1.0, std::acos(-1.0) / 2}) {
            const Hillside h{static_cast<HillsideShape>(shape), angle, 10, 20, 100, 0.05, 0.8};
            const std::vector<Vec2> ground = ground_of(h);
            EXPECT_NO_THROW(make_profile({ground, {}, to_string(h.shape)}, {})) << to_string(h.shape);
            EXPECT_NE(std::ranges::find(ground, Vec2(0, 0)), ground.end());
        }
    }
}

TEST(StressPoints, StayInTheRangesOfTheirAxes) {
    const auto axes = stress_axes();
    EXPECT_EQ(axes.size() * sizeof(double), sizeof(StressPoint)) << "a number without an axis is always 0";
    for (const StressPoint& point : stress_points(axes, 200, 3))
        for (const StressAxis& axis : axes) {
            EXPECT_GE(point.*axis.value, axis.low) << axis.name;
            EXPECT_LE(point.*axis.value, axis.high) << axis.name;
        }
}

TEST(StressScenes, MostAreValidInputAndEveryKindIsAmongThem) {
    constexpr int count = 400;
    std::set<std::string> kinds;
    int valid = 0;
    for (const StressPoint& point : stress_points(stress_axes(), count, 1)) {
        try {
            const Scene scene = stress_scene(point, "test");
            EXPECT_NEAR(std::sqrt(scene.source.area), point.size_m, 1e-6 * point.size_m);
            kinds.insert(to_string(static_cast<SourceKind>(point.source_kind)));
            ++valid;
        } catch (const InputError& error) {
            EXPECT_GT(std::string(error.what()).size(), 20U);
        }
    }
    EXPECT_EQ(kinds.size(), static_cast<std::size_t>(SourceKind::count));
    EXPECT_GT(valid, count * 6 / 10);
    RecordProperty("valid", std::to_string(valid));
}

TEST_F(StoreTest, AStressSceneAsACaseIsTheSameScene) {
    int compared = 0;
    for (const StressPoint& point : stress_points(stress_axes(), 60, 7)) {
        if (stress_site(point).free) {
            EXPECT_THROW(stress_case(point, "air", "air.csv", {}), InputError);
            continue;
        }
        const StressCase made = stress_case(point, "scene", "scene.csv", {{"run.courant", "0.1"}});
        std::ofstream(own.file("scene.csv")) << made.section;
        std::ofstream(own.file("scene.toml")) << made.text;
        std::optional<Scene> scene;
        try {
            scene = stress_scene(point, "scene");
        } catch (const InputError&) {
            EXPECT_THROW(make_scene(read_case(own.file("scene.toml"))), InputError);
            continue;
        }
        const Scene from_case = make_scene(read_case(own.file("scene.toml")));
        EXPECT_EQ(from_case.source.outline, scene->source.outline) << made.text;
        EXPECT_EQ(from_case.source.bed, scene->source.bed);
        EXPECT_EQ(from_case.material.friction_angle, scene->material.friction_angle);
        EXPECT_EQ(base_strength_ratio(from_case.material, from_case.effects, 0),
                  base_strength_ratio(scene->material, scene->effects, 0));
        EXPECT_EQ(from_case.run.resolution, scene->run.resolution);
        EXPECT_EQ(from_case.run.gravity, scene->run.gravity);
        EXPECT_EQ(from_case.run.courant, 0.1);
        ++compared;
    }
    EXPECT_GT(compared, 20);
}

TEST_F(StoreTest, StressRunsAreStoredAndTheSameForAnyNumberOfJobs) {
    std::vector<StressAxis> axes = stress_axes();
    for (StressAxis& axis : axes)
        if (axis.name == "resolution") axis.high = axis.low = 5;
    const auto points = stress_points(axes, 12, 5);
    Store store(path, Store::Mode::write);
    const auto one =
        run_stress(points, 5, store, {.jobs = 1, .settings = {}, .interrupt = nullptr, .on_run = {}});
    const auto two =
        run_stress(points, 5, store, {.jobs = 2, .settings = {}, .interrupt = nullptr, .on_run = {}});
    long ran = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        ASSERT_EQ(one[k].result.has_value(), two[k].result.has_value());
        if (!one[k].result) continue;
        ++ran;
        EXPECT_EQ(one[k].result->status, two[k].result->status);
        EXPECT_EQ(one[k].result->work.steps, two[k].result->work.steps);
        EXPECT_EQ(one[k].result->measures.front_mass_995_m, two[k].result->measures.front_mass_995_m);
    }
    EXPECT_GT(ran, 4);
    EXPECT_EQ(count("run"), 2 * ran);
}

TEST_F(StoreTest, StressTakesSettingsOfARunAndNoOthers) {
    const auto points = stress_points(stress_axes(), 1, 5);
    Store store(path, Store::Mode::write);
    const auto with = [&](const std::string& key, const std::string& value) {
        return input_error([&] {
            run_stress(points, 5, store,
                       {.jobs = 1, .settings = {{key, value}}, .interrupt = nullptr, .on_run = {}});
        });
    };
    EXPECT_TRUE(contains(with("run.courant", "2"), "--set: run.courant = 2"));
    EXPECT_TRUE(contains(with("material.friction_angle_deg", "30"), "is not a key of a run"));
    EXPECT_EQ(count("run"), 0);
    EXPECT_EQ(with("run.time_limit_s", "1e-6"), "");
}

TEST(StressTable, CountsEndingsAndShowsWhatIsNotSound) {
    const auto axes = stress_axes();
    std::vector<StressOutcome> outcomes(3);
    outcomes[0].refusal = "no room for the source";
    outcomes[1].result.emplace();
    outcomes[1].result->status = RunStatus::settled;
    outcomes[1].result->invariants = {{"speed", 0.5, 2.0, 0.1, 0.2}};
    outcomes[2].index = 2;
    outcomes[2].point.friction_angle_deg = 12.5;
    outcomes[2].result.emplace();
    outcomes[2].result->status = RunStatus::diverged;
    outcomes[2].result->status_detail = "speed at t = 1 s";
    outcomes[2].result->invariants = {{"speed", 2.5, 2.0, 1.0, 0.2}};
    EXPECT_TRUE(is_sound(outcomes[0]));
    EXPECT_TRUE(is_sound(outcomes[1]));
    EXPECT_FALSE(is_sound(outcomes[2]));
    const std::string text = stress_table(outcomes, axes);
    EXPECT_TRUE(contains(text, "3 scenes"));
    EXPECT_TRUE(contains(text, "refused"));
    EXPECT_TRUE(contains(text, "scene 2: diverged: speed at t = 1 s"));
    EXPECT_TRUE(contains(text, "friction_angle_deg 12.5"));
}

}  // namespace
}  // namespace runout
