#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "report/page/html.h"
#include "report/page/run_page_parts.h"

namespace runout {
namespace {

HtmlRow effect_row(const std::string& name, bool on, const std::string& why) {
    return {text_cell(name), text_cell(on ? "on" : "off"), text_cell(why)};
}

std::string with_spaces(std::string name) {
    std::ranges::replace(name, '_', ' ');
    return name;
}

constexpr std::array inputs = {"section", "source", "scenario"};

bool is_shown_elsewhere(const std::string& table) {
    return table == "run_effect" || table == "advice" || table == "place" || table.ends_with("_series");
}

}  // namespace

PageSection effects_section(const RunData& run) {
    std::vector<HtmlRow> rows;
    for (const char* core : {"gravity", "Coulomb friction", "incompressibility", "rigid bed"})
        rows.push_back(effect_row(core, true, "always: the core of the model"));
    for (const EffectRow& effect : run.run.effects) {
        const std::string settings = settings_text(run.run.effect_settings, effect.name);
        rows.push_back(effect_row(with_spaces(effect.name), effect.on,
                                  effect.why + (settings.empty() ? "" : " (" + settings + ")")));
        rows.back().push_back(number_cell(effect.cost_s, 3));
    }
    const std::vector<std::string> head = {"effect", "", "why", "its own work, s"};
    for (HtmlRow& row : rows) row.resize(head.size(), text_cell(""));
    return {"effects", "Effects: what was simulated and what not", html_table("Effects", head, rows), {}, {}};
}

PageSection inputs_section(const RunData& run) {
    std::string body;
    for (const std::string table : inputs) {
        std::vector<HtmlRow> rows;
        for (const StoredFact& fact : run.facts) {
            if (fact.table != table || std::holds_alternative<std::monostate>(fact.value)) continue;
            if (fact.column.ends_with("_hash")) continue;
            const ColumnWords words = column_words(fact.column);
            rows.push_back({text_cell(words.words), value_cell(fact.value), text_cell(words.unit),
                            text_cell(fact.meaning)});
        }
        body += fmt::format("<h3>{}</h3>\n", table == "scenario" ? "material, effects and settings" : table) +
                html_table("Inputs: " + table, {"input", "value", "unit", "meaning"}, rows);
    }
    return {"inputs", "Inputs", body, {}, {}};
}

PageSection further_section(const RunData& run) {
    std::string body;
    for (const StoredTable& table : run.further) {
        if (is_shown_elsewhere(table.name)) continue;
        constexpr std::size_t most_rows = 200;
        std::vector<HtmlRow> rows;
        for (const auto& values : table.rows) {
            if (rows.size() == most_rows) break;
            HtmlRow& row = rows.emplace_back();
            for (const StoredValue& value : values) row.push_back(value_cell(value));
        }
        std::vector<std::string> head;
        for (const std::string& column : table.columns) {
            const ColumnWords words = column_words(column);
            head.push_back(words.unit.empty() ? words.words : words.words + ", " + words.unit);
        }
        body += fmt::format("<h3>{}</h3>\n{}", html_text(with_spaces(table.name)), paragraph(table.meaning)) +
                html_table(table.name, head, rows);
        if (table.rows.size() > most_rows)
            body +=
                paragraph(fmt::format("{} more rows are in the database.", table.rows.size() - most_rows));
    }
    return {"further", "Also stored with this run", body, {}, {}};
}

PageSection provenance_section(const RunData& run) {
    const StoredRun& stored = run.run;
    const std::vector<HtmlRow> rows = {
        {text_cell("program"), text_cell(fmt::format("runout {} (revision {}, {})", stored.program_version,
                                                     stored.program_revision, stored.compiler))},
        {text_cell("run"), text_cell(std::to_string(stored.run_id))},
        {text_cell("started"), text_cell(stored.started_utc)},
        {text_cell("ended"), text_cell(stored.ended_utc)},
        {text_cell("scenario hash"), text_cell(stored.scenario_hash)},
        {text_cell("section"), text_cell(stored.section_origin)},
        {text_cell("hardware threads of the machine"), text_cell(std::to_string(stored.host_threads))},
    };
    return {"origin", "Where this comes from", html_table("Origin of this run", {}, rows), {}, {}};
}

}  // namespace runout
