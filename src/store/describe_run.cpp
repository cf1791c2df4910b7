#include <fmt/chrono.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>
#include <variant>

#include "core/machine.h"
#include "core/units.h"
#include "core/version.h"
#include "store/columns.h"
#include "store/store.h"

namespace runout {
namespace {

using Clock = std::chrono::system_clock;

std::string utc(Clock::time_point time) {
    return fmt::format("{:%Y-%m-%dT%H:%M:%S}Z", fmt::gmtime(Clock::to_time_t(time)));
}

Clock::duration wall_time(const RunWork& work) {
    return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(work.wall_s));
}

void describe_section(StoredRun& run, const Profile& profile) {
    run.section_origin = profile.origin;
    if (profile.map_line) run.section_attributes = profile.map_line->attributes;
    run.slope_angle_deg = degrees(profile.slope_angle);
    run.toe_chainage_m = profile.toe_chainage_m;
    run.toe_elevation_m = profile.toe_elevation_m;
    run.crest_chainage_m = profile.to_section(profile.ground[profile.crest]).x();
    run.face_height_m = profile.ground[profile.crest].y();
    run.toe_origin = profile.toe_given ? "given" : "found";
    run.crest_origin = profile.crest_given ? "given" : "found";
    run.section_read_as = profile.read_as;
    run.section_doubts = fmt::format("{}", fmt::join(profile.doubts, "\n"));
}

/// The database has no negative zero, and an infinity that is read of it is no number.
void make_as_read(double& number) {
    number = std::isfinite(number) ? number + 0.0 : std::numeric_limits<double>::quiet_NaN();
}

template <class Record, class Columns>
void make_as_read(Record& record, const Columns& columns) {
    for (const auto& column : columns) make_as_read(record.*column.value);
}

/// What is told of a run is to be what is read of it later.
void make_as_read(StoredRun& run) {
    for (double* number :
         {&run.discontinuity_angle_deg, &run.slope_angle_deg, &run.toe_chainage_m, &run.toe_elevation_m,
          &run.crest_chainage_m, &run.face_height_m, &run.friction_angle_deg})
        make_as_read(*number);
    make_as_read(run.measures, measure_fields());
    make_as_read(run.appraisal, appraisal_numbers());
    for (const WorkColumn& column : work_columns())
        if (const auto* member = std::get_if<double RunWork::*>(&column.member))
            make_as_read(run.work.**member);
    for (EffectRow& effect : run.effects) make_as_read(effect.cost_s);
    for (PlaceRecord& place : run.places) make_as_read(place, place_columns());
    for (BarrierRecord& barrier : run.barriers) make_as_read(barrier, barrier_columns());
}

}  // namespace

StoredRun describe_run(const Scene& scene, const RunResult& result, const Appraisal& appraisal) {
    const Clock::time_point now = Clock::now();
    StoredRun run;
    run.name = scene.name;
    run.source_type = to_string(scene.source.type);
    run.discontinuity_angle_deg = degrees(scene.source.discontinuity_angle);
    run.drop_height_datum = to_string(scene.source.datum);
    describe_section(run, scene.profile);
    run.friction_angle_deg = degrees(scene.material.friction_angle);
    run.scenario_hash = scenario_hash(scene);
    run.started_utc = utc(now - wall_time(result.work));
    run.ended_utc = utc(now);
    run.program_version = program_version();
    run.program_revision = program_revision();
    run.compiler = compiler_description();
    run.host_threads = static_cast<int>(std::thread::hardware_concurrency());
    run.status = result.status;
    run.status_detail = result.status_detail;
    run.measures = result.measures;
    run.work = result.work;
    run.effects = result.effects;
    run.effect_settings = effect_settings(scene.effects, scene.profile);
    run.advice = result.advice;
    run.places = result.places;
    run.barriers = result.barriers;
    run.machine = machine_description();
    run.appraisal = appraisal;
    make_as_read(run);
    return run;
}

}  // namespace runout
