#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "example_run.h"
#include "fuzz/bytes.h"
#include "fuzz/targets.h"
#include "report/compare/comparison.h"
#include "report/export/export_files.h"
#include "report/map/result_map.h"
#include "report/page/run_page.h"
#include "report/page/study_page.h"
#include "report/text/run_out_table.h"
#include "report/text/table.h"
#include "store/store.h"

namespace runout::fuzz {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

/// A place, a barrier, a place on the map: what the example leaves out.
Scene full_scene() {
    Scene scene = example_scene();
    scene.profile.map_line =
        MapLine{"EPSG:2326", {{834000, 816000}, {834060, 816000}}, {0, 60}, {{"slope_no", "11SW"}}};
    scene.effects.cohesion = Cohesion{.strength = 500};
    scene.places = {{"road", 12}};
    return scene;
}

RunResult full_result() {
    RunResult result = example_result();
    result.places = {
        {"road", "traffic", 12, 3.5, 1.5, 0.3, 2.5, 0.32, 2.4, 0.2, 4.5, {{1.5, 0.3, 2.5, 0.32, 1.5}}}};
    result.barriers = {{1.5, 2000, 1.7, 900, 300, 100, 0.5, 0, 3.5, 0.4, 2100, {{1.5, 2000, -10, 900, 300}}}};
    result.effects = {{"cohesion", true, "strength that does not come from pressure", 0.1}};
    result.advice = {"the inertial number is high"};
    return result;
}

/// A database with all kinds of rows, as it stands on the disk.
Bytes sound_database() {
    const std::string path = written({}, "-sound.db");
    fs::remove(path);
    {
        Store store(path, Store::Mode::write);
        const Scene scene = full_scene();
        store.add(scene, full_result(), example_appraisal(), {example_pilot()});
        RunResult failed = full_result();
        failed.status = RunStatus::diverged;
        store.add(scene, failed);
        const long study = store.begin_study("study", "[vary]\nsource.type = \"B\"\n");
        store.set_study_scenarios(study, {{0, scenario_hash(scene), R"({"source.type": "B"})", ""},
                                          {1, "", R"({"source.type": "D"})", "is not known"}});
        StoredLadder ladder;
        ladder.question_hash = "q";
        ladder.runs = {{"spacing", "0.1", 20, 1}};
        ladder.verdicts = {{"run_out_m", "converged", 12, 0.5, 0.1, 1, 12.1, 0.4, 1.1, 12.2}};
        store.add(ladder);
    }
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> text{std::istreambuf_iterator<char>(file), {}};
    fs::remove(path);
    return {text.begin(), text.end()};
}

Bytes damaged(std::span<const std::uint8_t> changes) {
    static const Bytes sound = sound_database();
    Bytes bytes = sound;
    for (std::size_t i = 0; i + 4 <= changes.size(); i += 4) {
        const std::size_t place = changes[i] * 65536U + changes[i + 1] * 256U + changes[i + 2];
        bytes[place % bytes.size()] = changes[i + 3];
    }
    return bytes;
}

void read_run(const Store& store, long run_id) {
    const RunData data = read_run_data(store, run_id);
    require(run_page(data, 20).size() > 1000, "a run has a page");
    run_json(data.run);
    run_summary(data.run);
    if (comparison_refusal(data).empty()) compare_run(data, 20);
    accept_input_error([&] { csv_files(data); });
    accept_input_error([&] { vtk_files(data, store.snapshots(run_id)); });
    static_cast<void>(store.invariants(run_id));
    static_cast<void>(store.pilots(run_id));
    static_cast<void>(store.place(run_id));
    static_cast<void>(store.question(run_id));
}

void read_studies(const Store& store) {
    for (const StoredStudy& study : store.studies())
        for (const RunOutTableFormat format : {RunOutTableFormat::text, RunOutTableFormat::json})
            run_out_table(study.name, store.study_rows(study.study_id), {}, format);
    static_cast<void>(store.chart_rows(std::nullopt));
    static_cast<void>(store.ladders());
    static_cast<void>(store.find_ladder("q"));
}

}  // namespace

void read_damaged_database(std::span<const std::uint8_t> changes) {
    const std::string path = written(damaged(changes), ".db");
    accept_input_error([&] {
        const Store store(path, Store::Mode::read);
        std::vector<StoredRun> runs;
        accept_input_error([&] { runs = store.runs(); });
        for (const TableFormat format : {TableFormat::text, TableFormat::csv, TableFormat::json})
            run_table(runs, format);
        for (const StoredRun& run : runs) accept_input_error([&] { read_run(store, run.run_id); });
        accept_input_error([&] { study_page("all", runs); });
        accept_input_error([&] { read_studies(store); });
        accept_input_error([&] { result_map(store, {}); });
    });
}

}  // namespace runout::fuzz
