#include "report/text/run_columns.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "store/columns.h"

namespace runout {
namespace {

Cell number(double value) {
    return std::isfinite(value) ? Cell(value) : Cell();
}
Cell number(long value) {
    return value;
}
Cell number(int value) {
    return static_cast<long>(value);
}

void append_measures(std::vector<RunColumn>& columns, const StoredRun& run) {
    for (const MeasureField& field : measure_fields())
        columns.push_back({field.name, is_result(run.status) ? number(run.measures.*field.value) : Cell()});
}

void append_work(std::vector<RunColumn>& columns, const RunWork& work) {
    for (const WorkColumn& column : work_columns())
        columns.push_back(
            {column.name, std::visit([&](auto member) { return number(work.*member); }, column.member)});
}

/// The error bar of a run that is not a result would be one of nothing.
void append_appraisal(std::vector<RunColumn>& columns, const StoredRun& run) {
    const Appraisal& appraisal = run.appraisal;
    const bool valid = is_result(run.status);
    columns.push_back({"accuracy_asked", appraisal.accuracy_asked});
    columns.push_back({"run_out_error_m", valid ? number(appraisal.run_out_error_m) : Cell()});
    columns.push_back({"reach_angle_error_deg", valid ? number(appraisal.reach_angle_error_deg) : Cell()});
    columns.push_back({"error_origin", appraisal.error_origin});
    columns.push_back({"error_note", appraisal.error_note});
    columns.push_back({"expected_cpu_s", number(appraisal.expected_cpu_s)});
    columns.push_back({"choosing_cpu_s", number(appraisal.choosing_cpu_s)});
}

/// An object; empty where the section came from no map.
Cell attributes_json(const std::vector<Attribute>& attributes) {
    if (attributes.empty()) return {};
    nlohmann::ordered_json object;
    for (const Attribute& attribute : attributes)
        std::visit(
            [&](const auto& value) {
                if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::monostate>)
                    object[attribute.name] = nullptr;
                else
                    object[attribute.name] = value;
            },
            attribute.value);
    return object.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace

std::vector<RunColumn> run_columns(const StoredRun& run) {
    std::vector<RunColumn> columns = {
        {"run_id", run.run_id > 0 ? Cell(run.run_id) : Cell()},
        {"name", run.name},
        {"status", std::string(to_string(run.status))},
        {"status_detail", run.status_detail},
        {"section_origin", run.section_origin},
        {"section_read_as", run.section_read_as},
        {"section_attributes", attributes_json(run.section_attributes)},
        {"toe_chainage_m", number(run.toe_chainage_m)},
        {"toe_elevation_m", number(run.toe_elevation_m)},
        {"toe_origin", run.toe_origin},
        {"crest_chainage_m", number(run.crest_chainage_m)},
        {"crest_origin", run.crest_origin},
        {"face_height_m", number(run.face_height_m)},
        {"section_doubts", run.section_doubts},
        {"source_type", run.source_type},
        {"discontinuity_angle_deg", number(run.discontinuity_angle_deg)},
        {"drop_height_datum", run.drop_height_datum},
        {"slope_angle_deg", number(run.slope_angle_deg)},
        {"friction_angle_deg", number(run.friction_angle_deg)},
    };
    columns.push_back({"front_definition", run.front_definition});
    append_measures(columns, run);
    append_appraisal(columns, run);
    append_work(columns, run.work);
    columns.push_back({"started_utc", run.started_utc});
    columns.push_back({"ended_utc", run.ended_utc});
    columns.push_back({"program_version", run.program_version});
    columns.push_back({"program_revision", run.program_revision});
    columns.push_back({"compiler", run.compiler});
    columns.push_back({"machine", run.machine});
    columns.push_back({"host_threads", number(run.host_threads)});
    columns.push_back({"scenario_hash", run.scenario_hash});
    return columns;
}

}  // namespace runout
