#include "report/page/run_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/units.h"

namespace runout {

RunData read_run_data(const Store& store, long run_id) {
    RunData data;
    data.run = store.run(run_id);
    data.geometry = store.geometry(run_id);
    data.series = store.series(run_id);
    data.deposit = store.deposit(run_id);
    data.envelope = store.envelope(run_id);
    data.stages = store.stages(run_id);
    data.phases = store.phases(run_id);
    data.frames = store.frames(run_id);
    data.facts = store.facts(run_id);
    data.further = store.further_tables(run_id);
    return data;
}

StoredValue fact_of(const RunData& data, const std::string& table, const std::string& column) {
    for (const StoredFact& fact : data.facts)
        if (fact.table == table && fact.column == column) return fact.value;
    return {};
}

const StoredTable* further_table(const RunData& data, const std::string& name) {
    const auto found = std::ranges::find(data.further, name, &StoredTable::name);
    return found == data.further.end() ? nullptr : &*found;
}

StoredValue cell_of(const StoredTable& table, const std::vector<StoredValue>& row,
                    const std::string& column) {
    const auto found = std::ranges::find(table.columns, column);
    return found == table.columns.end() ? StoredValue()
                                        : row[static_cast<std::size_t>(found - table.columns.begin())];
}

double number_of(const StoredValue& value) {
    if (const auto* number = std::get_if<double>(&value)) return *number;
    if (const auto* count = std::get_if<long>(&value)) return static_cast<double>(*count);
    return std::numeric_limits<double>::quiet_NaN();
}

std::string stored_text(const StoredValue& value) {
    if (const auto* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
    if (const auto* count = std::get_if<long>(&value)) return std::to_string(*count);
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    return {};
}

std::string run_title(const StoredRun& run) {
    return run.name.empty() ? run.section_origin : run.name;
}

double travel_ratio(const StoredRun& run) {
    return std::tan(radians(run.measures.reach_angle_deg));
}

}  // namespace runout
