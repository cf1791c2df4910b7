#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "report/text/table.h"
#include "store_fixture.h"

// A run is described once: what is printed when it ends is what its database says of it later.

namespace runout {
namespace {

using Json = nlohmann::ordered_json;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

class ToldRunTest : public StoreTest {
  protected:
    /// The description of the run, after it was stored.
    StoredRun store_and_tell(const Scene& scene, const RunResult& result, const Appraisal& appraisal) {
        StoredRun run = describe_run(scene, result, appraisal);
        run.run_id = Store(path, Store::Mode::write).add({scene, result, run, {}});
        return run;
    }

    void expect_same_later(const StoredRun& told) {
        const Store store(path, Store::Mode::read);
        EXPECT_EQ(run_json(told), run_json(store.run(told.run_id)));
        EXPECT_EQ(run_summary(told), run_summary(store.run(told.run_id)));
        const Json table = Json::parse(run_table(store.runs(), TableFormat::json));
        const Json printed = Json::parse(run_json(told));
        const Json& listed = table.at(static_cast<std::size_t>(told.run_id - 1));
        EXPECT_FALSE(listed.empty());
        for (const auto& [name, value] : listed.items())
            EXPECT_EQ(printed.at(name).dump(), value.dump()) << name;
    }
};

Scene scene_with_everything() {
    Scene scene = example_scene();
    scene.profile.toe_given = true;
    scene.profile.read_as = "was read with the columns x and z";
    scene.profile.doubts = {"a doubt", "another"};
    scene.profile.map_line = MapLine{.crs = "EPSG:2326",
                                     .points = {{834500, 818200}, {834560, 818200}},
                                     .chainage_m = {834492.25, 834552.25},
                                     .attributes = {{"slope", 0.1}, {"rank", 3L}, {"note", "zwölf"}}};
    scene.effects.cohesion.emplace();
    scene.places = {{"road", 3.3, 4.0, "traffic"}};
    return scene;
}

RunResult result_with_everything() {
    RunResult result = example_result();
    for (const EffectState& state : effect_states(scene_with_everything().effects, 1))
        result.effects.push_back({state.name, state.on, state.meaning, state.on ? 0.37 : nan});
    result.advice = {"an advice", "and one more"};
    result.places = {{"road", "traffic", 834515.55, 4.0, nan, 0.1, -0.0, 0.3, 0.2, 0.05, 0.7, {}}};
    result.barriers = {{0.1, 0.2, 0.3, 0.7, 1.1, -0.0, nan, 0.9, 1.3, 0.6, 0.11, {}}};
    return result;
}

TEST_F(ToldRunTest, IsThatOfTheDatabaseInEveryField) {
    expect_same_later(store_and_tell(scene_with_everything(), result_with_everything(), example_appraisal()));
}

TEST_F(ToldRunTest, IsThatOfTheDatabaseWhereNumbersAreMissingInfiniteOrNegativeZeros) {
    Scene scene = scene_with_everything();
    scene.profile.toe_chainage_m = -0.0;
    scene.profile.toe_elevation_m = -0.0;
    scene.profile.descends_with_chainage = false;
    RunResult result = result_with_everything();
    result.measures.run_out_m = -0.0;
    result.measures.reach_angle_deg = nan;
    result.measures.toe_thickness_m = std::numeric_limits<double>::infinity();
    result.work.spared_share = -0.0;
    const StoredRun told = store_and_tell(scene, result, {});
    EXPECT_FALSE(std::signbit(told.measures.run_out_m));
    expect_same_later(told);
}

TEST_F(ToldRunTest, IsThatOfTheDatabaseForARunThatIsNoResult) {
    RunResult result = result_with_everything();
    result.status = RunStatus::time_limit;
    result.status_detail = "still moving";
    expect_same_later(store_and_tell(scene_with_everything(), result, example_appraisal()));
}

TEST_F(ToldRunTest, IsThatOfTheDatabaseForTheSecondRunOfAScenario) {
    const Scene scene = scene_with_everything();
    store_and_tell(scene, result_with_everything(), {});
    Scene renamed = scene;
    renamed.name = "another name";
    expect_same_later(store_and_tell(renamed, result_with_everything(), example_appraisal()));
}

}  // namespace
}  // namespace runout
