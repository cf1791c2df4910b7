#pragma once

#include <optional>
#include <vector>

#include "report/text/intensity.h"
#include "store/store.h"

namespace runout {

/// All that is stored of a run.
struct RunData {
    StoredRun run;
    SectionGeometry geometry;
    std::vector<SeriesRow> series;
    std::vector<DepositRow> deposit;
    std::optional<Envelope> envelope;
    std::vector<StageRow> stages;
    std::vector<PhaseTime> phases;
    std::vector<Frame> frames;
    std::vector<StoredFact> facts;
    std::vector<StoredTable> further;
    Intensities intensities{};  ///< not stored: what the reader asks for
};

/// Throws InputError when there is no such run.
RunData read_run_data(const Store& store, long run_id);

/// The value of a column, or nothing when no table of the run has it.
StoredValue fact_of(const RunData& data, const std::string& table, const std::string& column);

/// The rows of one of the further tables; nullptr when the run has none there.
const StoredTable* further_table(const RunData& data, const std::string& name);

/// A cell of such a table by the name of its column; nothing when there is no such column.
StoredValue cell_of(const StoredTable& table, const std::vector<StoredValue>& row, const std::string& column);

/// A value as a number; NaN for anything else.
double number_of(const StoredValue& value);
/// A value as text, as short as it can be read back; empty for nothing.
std::string stored_text(const StoredValue& value);

/// The name that a run is shown by.
std::string run_title(const StoredRun& run);

/// Height over horizontal length from the head of the source to the distal margin; NaN without run-out.
double travel_ratio(const StoredRun& run);

}  // namespace runout
