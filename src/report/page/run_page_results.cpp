#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "report/page/html.h"
#include "report/page/run_page_parts.h"
#include "report/text/table.h"

namespace runout {
namespace {

std::string status_line(const StoredRun& run) {
    return fmt::format("<p><span class=\"badge\">{}</span></p>\n",
                       html_text(std::string(to_string(run.status))));
}

std::string answer_box(const StoredRun& run) {
    std::string lines;
    std::string line;
    for (const char letter : run_summary(run)) {
        if (letter != '\n') {
            line += letter;
            continue;
        }
        lines += paragraph(line);
        line.clear();
    }
    return fmt::format("<div class=\"answer{}\">\n{}</div>\n", is_result(run.status) ? "" : " failed", lines);
}

/// "run_out_m" -> "run_out_error_m": where the error bar of a measure stands, if it has one.
std::string error_column(const std::string& measure) {
    for (const char* unit : {"_m", "_deg"})
        if (measure.ends_with(unit))
            return measure.substr(0, measure.size() - std::string(unit).size()) + "_error" + unit;
    return {};
}

double error_of(const RunData& run, const std::string& measure) {
    const std::string column = error_column(measure);
    return column.empty() ? std::numeric_limits<double>::quiet_NaN() : number_of(fact_of(run, "run", column));
}

HtmlRow measure_row(const RunData& run, const MeasureField& field) {
    const ColumnWords words = column_words(field.name);
    const double error = error_of(run, field.name);
    return {text_cell(words.words), number_cell(run.run.measures.*field.value), text_cell(words.unit),
            text_cell(std::isfinite(error) ? fmt::format("± {:.2g}", error) : "not estimated"),
            text_cell(field.meaning)};
}

std::string measures_table(const RunData& run) {
    std::vector<HtmlRow> rows;
    for (const MeasureField& field : measure_fields()) rows.push_back(measure_row(run, field));
    return html_table("Results", {"measure", "value", "unit", "numerical error", "meaning"}, rows);
}

/// Of a run that is not a result: where it stood when it ended, marked as such.
std::string last_state(const RunData& run) {
    if (run.series.empty()) return {};
    const SeriesRow& last = run.series.back();
    return "<h3>Last state, not a result</h3>\n" +
           html_table(
               "Last state", {"", "value", "unit"},
               {{text_cell("time"), number_cell(last.time_s), text_cell("s")},
                {text_cell("99.5 % mass point past the toe"), number_cell(last.front_mass_995_m),
                 text_cell("m")},
                {text_cell("kinetic energy"), number_cell(last.kinetic_energy_j_m), text_cell("J/m")},
                {text_cell("potential energy"), number_cell(last.potential_energy_j_m), text_cell("J/m")}});
}

}  // namespace

std::string numerical_error_words(const RunData& run) {
    const double run_out = error_of(run, "run_out_m"), angle = error_of(run, "reach_angle_deg");
    if (!std::isfinite(run_out) && !std::isfinite(angle)) return "not estimated";
    std::string words;
    if (std::isfinite(run_out)) words = fmt::format("run-out ± {:.2g} m", run_out);
    if (std::isfinite(angle))
        words += fmt::format("{}reach angle ± {:.2g} deg", words.empty() ? "" : ", ", angle);
    const std::string note = stored_text(fact_of(run, "run", "error_note"));
    return note.empty() ? words : words + "; " + note;
}

PageSection answer_section(const RunData& run) {
    std::string body = answer_box(run.run) + status_line(run.run);
    body += is_result(run.run.status) ? measures_table(run) : last_state(run);
    return {"result", "Result", body, {}, {}};
}

PageSection stages_section(const RunData& run) {
    std::vector<HtmlRow> rows;
    for (const StageRow& stage : run.stages)
        rows.push_back({number_cell(stage.time_s), number_cell(stage.area_m2),
                        number_cell(stage.surface_angle_deg), number_cell(stage.deposit_height_m),
                        number_cell(stage.run_out_m)});
    if (rows.empty()) return {"stages", "Stages", {}, {}, {}};
    return {
        "stages",
        "Stages",
        html_table("Stages of the release",
                   {"time, s", "area released, m²", "surface angle, deg", "height, m", "run-out, m"}, rows),
        {},
        {}};
}

PageSection accuracy_section(const RunData& run) {
    const RunWork& work = run.run.work;
    const double along = std::sqrt(run.run.measures.source_area_m2) / work.particle_spacing_m;
    const auto count = [](long number) { return value_cell(StoredValue(number)); };
    std::vector<HtmlRow> rows = {
        {text_cell("particles"), count(work.particles), text_cell("")},
        {text_cell("particle spacing"), number_cell(work.particle_spacing_m), text_cell("m")},
        {text_cell("particles along the square root of the source area"), number_cell(along, 3),
         text_cell("")},
        {text_cell("time steps"), count(work.steps), text_cell("")},
        {text_cell("iterations of the pressure equation"), count(work.pressure_iterations), text_cell("")},
        {text_cell("simulated time"), number_cell(work.simulated_s), text_cell("s")},
        {text_cell("time at the clock"), number_cell(work.wall_s), text_cell("s")},
        {text_cell("processor time"), number_cell(work.cpu_s), text_cell("s")},
        {text_cell("threads"), count(work.threads), text_cell("")},
    };
    std::vector<HtmlRow> phases;
    for (const PhaseTime& phase : run.phases)
        phases.push_back({text_cell(phase.phase), number_cell(phase.wall_s),
                          number_cell(100 * phase.wall_s / work.wall_s, 3)});
    std::string body = paragraph("Numerical error: " + numerical_error_words(run) + ".") +
                       html_table("Cost", {"", "value", "unit"}, rows);
    if (!phases.empty())
        body += "<h3>Where the time went</h3>\n" +
                html_table("Time by phase", {"phase of the step", "s", "% of the run"}, phases);
    return {"cost", "What this accuracy cost", body, {}, {}};
}

}  // namespace runout
