// Results on the map: where a run-out ends on its line, which layers hold what, what a GIS reads back.

#include <SQLiteCpp/Database.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>

#include "core/units.h"
#include "example_run.h"
#include "map_fixture.h"
#include "measures/deposit.h"
#include "report/map/map_runs.h"
#include "report/map/result_map.h"
#include "report/text/reach_probability.h"
#include "store/store.h"

namespace runout {
namespace {

MapLine line_at(double east, const std::string& name) {
    // 80 m long, from the hill southwards; a bend at 50 m.
    return {test_wkt(),
            {{east, 816100}, {east, 816050}, {east + 18, 816026}},
            {0, 50, 80},
            {{"name", name}, {"slope", 7L}, {"note", {}}}};
}

/// A cut of 10 m with its toe at chainage 30 and ground that falls gently and steps down once beyond it.
Scene scene_on(const MapLine& line, bool mirrored = false) {
    Scene scene = example_scene();
    std::vector<Vec2> points = {{0, 52}, {20, 51}, {30, 41}, {45, 40}, {45, 38.5}, {80, 37}};
    if (mirrored) {
        std::vector<Vec2> reversed;
        for (auto p = points.rbegin(); p != points.rend(); ++p) reversed.emplace_back(80 - p->x(), p->y());
        points = reversed;
    }
    ProfileOptions options;
    options.toe_chainage = Chainage(mirrored ? 50 : 30);
    scene.profile = make_profile({points, {}, "dem.tif along lines.gpkg"}, options);
    SourceSpec wedge;
    wedge.base_angle = radians(30);
    wedge.scarp_angle = radians(80);
    scene.source = derive_source(scene.profile, wedge);
    scene.profile.map_line = line;
    scene.name = "run-" + text_of(line.attributes.front().value);
    return scene;
}

RunResult result_with(RunStatus status, double run_out) {
    RunResult result = example_result();
    result.status = status;
    result.measures.run_out_m = run_out;
    result.measures.source_area_m2 = 16;
    result.deposit = {{22, 49, 0.2, 0.3}, {24, 47, 0.8, 0.9}, {26, 45, 0.7, 0.8}};
    return result;
}

class ResultMapTest : public MapFiles {
  protected:
    void add(const Scene& scene, const RunResult& result) {
        Store(database(), Store::Mode::write).add(scene, result);
    }
    [[nodiscard]] std::string database() const { return path("runs.db"); }
    [[nodiscard]] ResultMap map(const MapOptions& options = {}) const {
        return result_map(Store(database(), Store::Mode::read), options);
    }
    [[nodiscard]] static const MapLayer& layer(const ResultMap& map, const std::string& name) {
        for (const MapLayer& found : map.sheet.layers)
            if (found.name == name) return found;
        throw std::logic_error("no layer " + name);
    }
    [[nodiscard]] static FieldValue value(const MapFeature& feature, const std::string& name) {
        for (const Attribute& attribute : feature.attributes)
            if (attribute.name == name) return attribute.value;
        throw std::logic_error("no attribute " + name);
    }
};

// ---- lines

TEST(MapLine, PointsAndPartsAreOnTheLine) {
    const MapLine line = line_at(834000, "A");
    EXPECT_EQ(point_at(line, -1), Vec2(834000, 816100));
    EXPECT_EQ(point_at(line, 99), Vec2(834018, 816026));
    EXPECT_LT((point_at(line, 65) - Vec2(834009, 816038)).norm(), 1e-9);
    const Polyline part = part_between(line, 65, 20);
    ASSERT_EQ(part.size(), 3u);
    EXPECT_EQ(part[0], Vec2(834000, 816080));
    EXPECT_EQ(part[1], Vec2(834000, 816050));
    EXPECT_EQ(attribute_text(line.attributes, {"note", "slope"}), "7") << "an empty attribute says nothing";
}

// ---- the store

TEST_F(ResultMapTest, TheLineIsStoredWithTheRunAndNotPartOfTheScenario) {
    Scene here = scene_on(line_at(834000, "A"));
    Scene there = scene_on(line_at(834040, "B"));
    Scene nowhere = here;
    nowhere.profile.map_line.reset();
    EXPECT_EQ(scenario_hash(here), scenario_hash(nowhere));
    add(here, result_with(RunStatus::settled, 9));
    add(there, result_with(RunStatus::settled, 9));
    add(nowhere, result_with(RunStatus::settled, 9));
    add(here, result_with(RunStatus::settled, 9));
    const Store store(database(), Store::Mode::read);
    const auto runs = store.runs();
    ASSERT_EQ(runs.size(), 4u);
    EXPECT_EQ(runs[0].scenario_hash, runs[1].scenario_hash);
    EXPECT_EQ(runs[1].section_attributes, there.profile.map_line->attributes);
    EXPECT_TRUE(runs[2].section_attributes.empty());
    EXPECT_FALSE(store.place(runs[2].run_id).has_value());
    const RunPlace place = store.place(runs[3].run_id).value();
    EXPECT_EQ(place.line.points, here.profile.map_line->points);
    EXPECT_EQ(place.line.chainage_m, here.profile.map_line->chainage_m);
    EXPECT_EQ(place.line.crs, here.profile.map_line->crs);
    EXPECT_EQ(place.source_outline.size(), here.source.outline.size());
    EXPECT_EQ(place.head, here.profile.to_section(here.source.head));
}

TEST_F(ResultMapTest, AQuestionTellsWhatIsAskedFromHowFinelyItIsComputed) {
    const Scene first = scene_on(line_at(834000, "A"));
    Scene finer = first;
    finer.run.resolution = 80;
    Scene weaker = first;
    weaker.material.friction_angle = radians(30);
    for (const Scene& scene : {first, finer, weaker}) add(scene, result_with(RunStatus::settled, 9));
    const Store store(database(), Store::Mode::read);
    EXPECT_EQ(store.question(1).physical, store.question(2).physical);
    EXPECT_NE(store.question(1).numerical, store.question(2).numerical);
    EXPECT_NE(store.question(1).physical, store.question(3).physical);
    EXPECT_EQ(store.question(1).source, store.question(3).source);
}

// ---- where it ends

TEST_F(ResultMapTest, TheDistalPointIsOnTheLineAtTheStoredRunOut) {
    int id = 0;
    for (const bool mirrored : {false, true})
        for (const double run_out : {0.5, 9.0, 14.9, 15.03, 16.0, 17.3, 31.7}) {
            const Scene scene = scene_on(line_at(834000, "A"), mirrored);
            add(scene, result_with(RunStatus::settled, run_out));
            const RunPlace place = Store(database(), Store::Mode::read).place(++id).value();
            const double chainage = chainage_at_run_out(place, run_out);
            EXPECT_NEAR((mirrored ? -1 : 1) * (chainage - place.toe_chainage_m), run_out, 1e-9);
        }
}

// A run of before database 10 has its run-out along the bed.
TEST_F(ResultMapTest, AFormerRunOutIsPlacedAlongTheBedAndSaid) {
    for (const double run_out : {0.5, 9.0, 14.9, 15.03, 16.0, 17.3, 31.7}) {
        const Scene scene = scene_on(line_at(834000, "A"));
        add(scene, result_with(RunStatus::settled, run_out));
        SQLite::Database(database(), SQLite::OPEN_READWRITE).exec("UPDATE run SET front_definition = 'top'");
        const MapRuns runs = map_runs(Store(database(), Store::Mode::read), true);
        const double beyond = run_out_from_toe(runs.runs.back());
        const BedLine bed(scene.source.bed);
        // At a step down the length jumps by its height; the point stands at the step then.
        EXPECT_GE(run_out, distance_along_bed(bed, beyond - 1e-9) - 1e-6);
        EXPECT_LE(run_out, distance_along_bed(bed, beyond + 1e-9) + 1e-6);
    }
    EXPECT_TRUE(std::ranges::any_of(map().remarks, [](const std::string& remark) {
        return remark.find("former definition of the front") != std::string::npos;
    }));
}

TEST_F(ResultMapTest, DebrisThatDoesNotPassTheToeEndsWhereItsDepositDoes) {
    add(scene_on(line_at(834000, "A")), [] {
        RunResult result = result_with(RunStatus::settled, 0);
        result.measures.front_thickness_m = 0.85;
        return result;
    }());
    const ResultMap made = map();
    const MapFeature& point = layer(made, "runout_extent").features.at(0);
    EXPECT_EQ(std::get<double>(value(point, "chainage_m")), 24);
    EXPECT_EQ(point.points.at(0), Vec2(834000, 816076));
}

// ---- what arrives

TEST_F(ResultMapTest, PlacesAndIntensitiesLieOnTheLine) {
    RunResult result = result_with(RunStatus::settled, 9);
    result.measures.front_thickness_m = 0.2;
    result.envelope.greatest_thickness_m = {0.1, 0.5, 1.5};
    result.envelope.greatest_speed_m_s = {3.0, 3.0, 2.0};
    PlaceRecord road;
    road.name = "road";
    road.chainage_m = 33;
    road.width_m = 4;
    road.arrival_time_s = 1.5;
    road.greatest_thickness_m = 0.5;
    PlaceRecord path = road;
    path.name = "path";
    path.width_m = 0;
    path.arrival_time_s = std::nan("");
    result.places = {road, path};
    add(scene_on(line_at(834000, "A")), result);
    const ResultMap made = map();
    const RunPlace place = Store(database(), Store::Mode::read).place(1).value();
    const auto& places = layer(made, "place").features;
    ASSERT_EQ(places.size(), 2u);
    EXPECT_EQ(places[0].points.front(), point_at(place.line, 33));
    EXPECT_EQ(places[0].points.back(), point_at(place.line, 37));
    EXPECT_EQ(std::get<long>(value(places[0], "reached")), 1);
    EXPECT_EQ(std::get<double>(value(places[0], "greatest_thickness_m")), 0.5);
    EXPECT_EQ(std::get<long>(value(places[1], "reached")), 0);
    EXPECT_EQ(std::get<long>(value(places[1], "within_error")), 0);
    EXPECT_EQ(places[1].points.size(), 3u) << "a bar across the line";
    const auto& stretches = layer(made, "intensity").features;
    ASSERT_EQ(stretches.size(), 2u);
    EXPECT_EQ(std::get<std::string>(value(stretches[0], "intensity")), "medium");
    EXPECT_EQ(std::get<std::string>(value(stretches[1], "intensity")), "high");
    const double from = std::get<double>(value(stretches[1], "from_m"));
    EXPECT_NEAR(from, -3.5 + 1.5 * 0.7, 1e-12) << "halfway between two nodes";
    EXPECT_LT((stretches[1].points.front() - point_at(place.line, place.toe_chainage_m + from)).norm(), 1e-6);
}

TEST_F(ResultMapTest, IntensitiesAreOfTheClassesThatAreAskedFor) {
    RunResult result = result_with(RunStatus::settled, 9);
    result.measures.front_thickness_m = 0.2;
    result.envelope.greatest_thickness_m = {0.1, 0.5, 1.5};
    result.envelope.greatest_speed_m_s = {3.0, 3.0, 2.0};
    add(scene_on(line_at(834000, "A")), result);
    MapOptions options;
    options.intensities = intensities_from({"low=0,0", "middle=0.4,1", "grave <1>=1,1"}, "--intensity");
    const ResultMap made = result_map(Store(database(), Store::Mode::read), options);
    const MapLayer& drawn = layer(made, "intensity");
    EXPECT_EQ(drawn.title, "Classes as given by --intensity.");
    ASSERT_EQ(drawn.features.size(), 2u);
    EXPECT_EQ(std::get<std::string>(value(drawn.features[0], "intensity")), "middle");
    EXPECT_EQ(std::get<long>(value(drawn.features[0], "rank")), 2);
    EXPECT_EQ(std::get<std::string>(value(drawn.features[1], "intensity")), "grave <1>");
    EXPECT_EQ(std::get<long>(value(drawn.features[1], "rank")), 3);
    EXPECT_NE(drawn.style.find("grave &lt;1&gt;"), std::string::npos);
    EXPECT_EQ(drawn.style.find("grave <1>"), std::string::npos);
}

// ---- layers

TEST_F(ResultMapTest, LayersHoldTheRunsWithTheirSections) {
    add(scene_on(line_at(834000, "A")), result_with(RunStatus::settled, 9));
    add(scene_on(line_at(834020, "B")), result_with(RunStatus::settled, 12));
    add(scene_on(line_at(834040, "C")), result_with(RunStatus::diverged, 3));
    add(scene_on(line_at(834060, "D")), result_with(RunStatus::settled, 11));
    add(scene_on(line_at(834080, "E")), result_with(RunStatus::stable, 0));
    const ResultMap made = map();
    EXPECT_EQ(layer(made, "section").features.size(), 5u);
    EXPECT_EQ(layer(made, "source").features.size(), 4u) << "a failed run is in its own layer only";
    EXPECT_EQ(layer(made, "deposit").features.size(), 3u);
    EXPECT_EQ(layer(made, "thickness").features.size(), 9u);
    EXPECT_EQ(layer(made, "runout_extent").features.size(), 3u)
        << "a source that stands has no distal margin";
    EXPECT_EQ(layer(made, "hazard_band").features.size(), 1u) << "no band passes over a failed section";
    const MapFeature& failed = layer(made, "failed_run").features.at(0);
    EXPECT_EQ(std::get<std::string>(value(failed, "status")), "diverged");
    EXPECT_TRUE(std::holds_alternative<std::monostate>(value(failed, "run_out_m")));
    EXPECT_EQ(std::get<std::string>(value(failed, "section_name")), "C");
    EXPECT_EQ(std::get<long>(value(failed, "section_slope")), 7);
    for (const MapFeature& bar : layer(made, "runout_extent_line").features) {
        EXPECT_NEAR((bar.points.front() - bar.points.back()).norm(), 2 * 4, 1e-6)
            << "sqrt(16 m2) to either side";
        EXPECT_LT((bar.points.front() + bar.points.back() - 2 * bar.points[1]).norm(), 1e-6);
    }
}

TEST_F(ResultMapTest, NeighboursAreNearEnoughAndPointTheSameWay) {
    add(scene_on(line_at(834000, "A")), result_with(RunStatus::settled, 9));
    add(scene_on(line_at(834050, "B")), result_with(RunStatus::settled, 12));
    EXPECT_EQ(layer(map({.neighbours_within_m = 51}), "hazard_band").features.size(), 1u);
    EXPECT_EQ(layer(map({.neighbours_within_m = 49}), "hazard_band").features.size(), 0u);
}

TEST_F(ResultMapTest, TheBandReachesFromTheHeadsToTheMargins) {
    add(scene_on(line_at(834000, "A")), result_with(RunStatus::settled, 9));
    add(scene_on(line_at(834020, "B")), result_with(RunStatus::settled, 12));
    const ResultMap made = map();
    const MapFeature& band = layer(made, "hazard_band").features.at(0);
    const Store store(database(), Store::Mode::read);
    for (const long id : {1L, 2L}) {
        const RunPlace place = store.place(id).value();
        const Vec2 head = point_at(place.line, place.head.x());
        const Vec2 margin = point_at(place.line, chainage_at_run_out(place, id == 1 ? 9 : 12));
        for (const Vec2& corner : {head, margin})
            EXPECT_NE(std::ranges::find(band.points, corner), band.points.end());
    }
    EXPECT_TRUE(is_valid_ring(band.points));
}

TEST_F(ResultMapTest, OneRunForEachQuestionTheFinest) {
    RunResult coarse = result_with(RunStatus::settled, 9);
    coarse.work.particle_spacing_m = 0.4;
    RunResult fine = result_with(RunStatus::settled, 10);
    fine.work.particle_spacing_m = 0.1;
    RunResult finest_but_failed = result_with(RunStatus::diverged, 11);
    finest_but_failed.work.particle_spacing_m = 0.05;
    Scene scene = scene_on(line_at(834000, "A"));
    add(scene, fine);
    scene.run.resolution = 20;
    add(scene, coarse);
    scene.run.resolution = 80;
    add(scene, finest_but_failed);
    EXPECT_EQ(layer(map(), "runout_extent").features.size(), 1u);
    EXPECT_EQ(std::get<double>(value(layer(map(), "runout_extent").features.at(0), "run_out_m")), 10);
    EXPECT_EQ(layer(map({.every_run = true}), "runout_extent").features.size(), 2u);
    EXPECT_EQ(layer(map({.every_run = true}), "failed_run").features.size(), 1u);
    EXPECT_TRUE(layer(map({.every_run = true}), "reach_probability").features.empty())
        << "resolutions are no scenarios";
}

TEST_F(ResultMapTest, RunsWithoutAPlaceAreCountedAndNothingElseIsRefused) {
    Scene scene = scene_on(line_at(834000, "A"));
    scene.profile.map_line.reset();
    add(scene, result_with(RunStatus::settled, 9));
    EXPECT_TRUE(has_part(error_of([&] { static_cast<void>(map()); }),
                         "finds no run that lies on a map; take sections from lines"));
    add(scene_on(line_at(834000, "A")), result_with(RunStatus::settled, 9));
    ASSERT_EQ(map().remarks.size(), 1u);
    EXPECT_TRUE(has_part(map().remarks[0], "1 runs are not on the map"));
}

// ---- probability of reaching

TEST(ReachProbability, IsTheShareOfTheScenarios) {
    std::vector<ReachSample> samples;
    for (int i = 1; i <= 100; ++i) samples.push_back({static_cast<double>(i), 1});
    EXPECT_DOUBLE_EQ(probability_of_reaching(samples, 91).value, 0.1);
    EXPECT_DOUBLE_EQ(probability_of_reaching(samples, 91).standard_error, 0.03);
    EXPECT_DOUBLE_EQ(probability_of_reaching(samples, 0).value, 1);
    EXPECT_DOUBLE_EQ(probability_of_reaching(samples, 101).value, 0);
    EXPECT_EQ(distance_reached(samples, 0.5).distance_m, 51);  // 51 to 100 are half of them
    EXPECT_EQ(distance_reached(samples, 0.1).distance_m, 91);
    EXPECT_EQ(distance_reached(samples, 0.01).distance_m, 100);
    EXPECT_EQ(distance_reached(samples, 0.1).low_m, 85);   // 10 + 5.9 of 100
    EXPECT_EQ(distance_reached(samples, 0.1).high_m, 96);  // 10 - 5.9 of 100
    EXPECT_TRUE(std::isnan(distance_reached(samples, 0.01).high_m));
    EXPECT_TRUE(std::isnan(distance_reached(samples, 0.009).distance_m)) << "100 scenarios know no 0.9 %";
}

TEST(ReachProbability, WeightsCount) {
    const std::vector<ReachSample> samples = {{10, 3}, {20, 1}};
    EXPECT_DOUBLE_EQ(probability_of_reaching(samples, 15).value, 0.25);
    EXPECT_DOUBLE_EQ(effective_count(samples), 1.6);
    EXPECT_DOUBLE_EQ(probability_of_reaching(samples, 15).standard_error, std::sqrt(0.25 * 0.75 / 1.6));
    EXPECT_EQ(distance_reached(samples, 0.7).distance_m, 10);
}

TEST_F(ResultMapTest, ASweepGivesProbabilitiesAndTellsWhatItCannotGive) {
    for (int i = 0; i < 10; ++i) {
        Scene scene = scene_on(line_at(834000, "A"));
        scene.material.friction_angle = radians(30 + i);
        add(scene, result_with(i == 9 ? RunStatus::stable : RunStatus::settled, i == 9 ? 0 : 20 - i));
    }
    const ResultMap made = map();
    const MapLayer& stretches = layer(made, "reach_probability");
    ASSERT_EQ(stretches.features.size(), 9u);
    EXPECT_DOUBLE_EQ(std::get<double>(value(stretches.features[0], "probability")), 0.9)
        << "a source that stands counts";
    EXPECT_DOUBLE_EQ(std::get<double>(value(stretches.features[8], "probability")), 0.1);
    const MapLayer& bars = layer(made, "reach_probability_line");
    ASSERT_EQ(bars.features.size(), 2u);
    EXPECT_EQ(std::get<double>(value(bars.features[0], "run_out_m")), 16);
    EXPECT_EQ(std::get<double>(value(bars.features[1], "run_out_m")), 20);
    ASSERT_EQ(made.remarks.size(), 1u);
    EXPECT_TRUE(has_part(made.remarks[0],
                         "10 scenarios are too few for the distance reached with 1 %; it takes 100"));
}

// ---- files

TEST_F(ResultMapTest, AGeoPackageIsReadBackAsWritten) {
    add(scene_on(line_at(834000, "A")), result_with(RunStatus::settled, 9));
    add(scene_on(line_at(834020, "B")), result_with(RunStatus::settled, 12));
    add(scene_on(line_at(834060, "C")), result_with(RunStatus::left_section, 3));
    write_map(path("map.gpkg"), map().sheet, "");
    const GDALDatasetUniquePtr data(GDALDataset::Open(path("map.gpkg").c_str(), GDAL_OF_VECTOR));
    ASSERT_TRUE(data);
    std::map<std::string, OGRwkbGeometryType> types;
    for (OGRLayer* written : data->GetLayers()) types[written->GetName()] = written->GetGeomType();
    const std::map<std::string, OGRwkbGeometryType> expected = {
        {"hazard_band", wkbPolygon},  {"section", wkbLineString},    {"deposit", wkbLineString},
        {"thickness", wkbLineString}, {"source", wkbLineString},     {"runout_extent_line", wkbLineString},
        {"runout_extent", wkbPoint},  {"failed_run", wkbLineString}, {"layer_styles", wkbNone}};
    EXPECT_EQ(types, expected) << "layers without features are left out";
    OGRLayer* extent = data->GetLayerByName("runout_extent");
    EXPECT_STREQ(extent->GetSpatialRef()->GetAuthorityCode(nullptr), "2326");
    const OGRFeatureUniquePtr first(extent->GetNextFeature());
    const RunPlace place = Store(database(), Store::Mode::read).place(1).value();
    const Vec2 wanted = point_at(place.line, chainage_at_run_out(place, 9));
    const OGRPoint* point = first->GetGeometryRef()->toPoint();
    EXPECT_LT((Vec2(point->getX(), point->getY()) - wanted).norm(), 1e-6);
    EXPECT_EQ(first->GetFieldAsDouble("run_out_m"), 9);
    EXPECT_STREQ(first->GetFieldAsString("section_name"), "A");
    EXPECT_EQ(first->GetFieldAsInteger("section_slope"), 7);
    const OGRFeatureUniquePtr failed(data->GetLayerByName("failed_run")->GetNextFeature());
    EXPECT_EQ(failed->IsFieldSetAndNotNull(failed->GetFieldIndex("run_out_m")), 0);
    EXPECT_STREQ(failed->GetFieldAsString("status"), "left_section");
    OGRLayer* styles = data->GetLayerByName("layer_styles");
    EXPECT_EQ(styles->GetFeatureCount(), 8);
    for (const auto& row : *styles)
        EXPECT_TRUE(has_part(row->GetFieldAsString("styleQML"), "<renderer-v2 type="));
}

TEST_F(ResultMapTest, AnotherCoordinateSystemAndGeoJsonKeepThePlaceToAMillimetre) {
    add(scene_on(line_at(834000, "A")), result_with(RunStatus::settled, 9));
    write_map(path("map.geojson"), map().sheet, "");
    write_map(path("utm.gpkg"), map().sheet, "EPSG:32650");
    const RunPlace place = Store(database(), Store::Mode::read).place(1).value();
    const Vec2 wanted = point_at(place.line, chainage_at_run_out(place, 9));
    for (const char* name : {"map.geojson", "utm.gpkg"}) {
        const GDALDatasetUniquePtr data(GDALDataset::Open(path(name).c_str(), GDAL_OF_VECTOR));
        ASSERT_TRUE(data) << name;
        OGRLayer* written = data->GetLayerByName("runout_extent");
        if (written == nullptr) {
            written = data->GetLayer(0);
            written->SetAttributeFilter("layer = 'runout_extent'");
        }
        const OGRFeatureUniquePtr feature(written->GetNextFeature());
        ASSERT_TRUE(feature) << name;
        OGRSpatialReference hong_kong = test_reference("EPSG:2326");
        ASSERT_EQ(feature->GetGeometryRef()->transformTo(&hong_kong), OGRERR_NONE);
        const OGRPoint* point = feature->GetGeometryRef()->toPoint();
        EXPECT_LT((Vec2(point->getX(), point->getY()) - wanted).norm(), 1e-3) << name;
    }
}

TEST_F(ResultMapTest, AMapReplacesItsOwnUntilItWasEdited) {
    add(scene_on(line_at(834000, "A")), result_with(RunStatus::settled, 9));
    const MapSheet sheet = map().sheet;
    for (const std::string name : {"map.gpkg", "map.geojson"}) {
        for (int time = 0; time < 2; ++time) write_map(path(name), sheet, "");
        {
            const GDALDatasetUniquePtr data(
                GDALDataset::Open(path(name).c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE));
            ASSERT_TRUE(data);
            OGRLayer* layer = data->GetLayer(0);
            const OGRFeatureUniquePtr feature(layer->GetNextFeature());
            feature->SetField(0, 99);  // the number of the run
            ASSERT_EQ(layer->SetFeature(feature.get()), OGRERR_NONE);
        }
        EXPECT_TRUE(
            has_part(error_of([&] { write_map(path(name), sheet, ""); }), "exists, and is not known"));
        write_map(path(name), sheet, "", {.overwrite = true});
        write_map(path(name), sheet, "");
    }
}

TEST_F(ResultMapTest, OpeningAMapIsNotEditingIt) {
    add(scene_on(line_at(834000, "A")), result_with(RunStatus::settled, 9));
    write_map(path("map.gpkg"), map().sheet, "");
    for (const char* journal : {"WAL", "DELETE"}) {  // as QGIS does on opening and on closing
        const GDALDatasetUniquePtr data(
            GDALDataset::Open(path("map.gpkg").c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE));
        ASSERT_TRUE(data);
        data->ReleaseResultSet(
            data->ExecuteSQL((std::string("PRAGMA journal_mode = ") + journal).c_str(), nullptr, ""));
    }
    write_map(path("map.gpkg"), map().sheet, "");
}

TEST_F(ResultMapTest, AMapThatAnotherProgramHasOpenIsNotReplaced) {
    add(scene_on(line_at(834000, "A")), result_with(RunStatus::settled, 9));
    write_map(path("map.gpkg"), map().sheet, "");
    for (const char* ending : {"-wal", "-journal"}) {
        std::ofstream(path("map.gpkg") + ending) << "x";
        const std::string sentence =
            error_of([&] { write_map(path("map.gpkg"), map().sheet, "", {.overwrite = true}); });
        EXPECT_TRUE(has_part(sentence, "close the program that has it open")) << sentence;
        std::filesystem::remove(path("map.gpkg") + ending);
    }
    write_map(path("map.gpkg"), map().sheet, "");
}

TEST_F(ResultMapTest, RefusesPlacesAndFormats) {
    add(scene_on(line_at(834000, "A")), result_with(RunStatus::settled, 9));
    const MapSheet sheet = map().sheet;
    const auto refusal = [&](const std::string& name, const std::string& crs) {
        return error_of([&] { write_map(name, sheet, crs); });
    };
    EXPECT_TRUE(
        has_part(refusal(path("map.shp"), ""), "is of no known format; end it with .gpkg or .geojson"));
    EXPECT_TRUE(has_part(refusal(path("none/map.gpkg"), ""), "lies in a folder that does not exist"));
    EXPECT_TRUE(has_part(refusal(path("map.gpkg"), "EPSG:nonsense"),
                         "--crs = EPSG:nonsense: is not a known coordinate system"));
    EXPECT_TRUE(has_part(refusal(path("map.geojson"), "EPSG:2326"), "does not apply to GeoJSON"));
    EXPECT_FALSE(std::filesystem::exists(path("map.gpkg")));
}

}  // namespace
}  // namespace runout
