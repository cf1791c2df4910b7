#include <fmt/format.h>

#include <cmath>

#include "report/export/export_files.h"
#include "store/columns.h"

namespace runout {
namespace {

template <class Row>
std::string csv_of(const std::vector<Row>& rows, std::span<const RealColumn<Row>> columns) {
    std::string text;
    for (const auto& column : columns) text += fmt::format("{}{}", text.empty() ? "" : ",", column.name);
    text += "\n";
    for (const Row& row : rows) {
        std::string line;
        for (const auto& column : columns) {
            const double value = row.*column.value;  // the shortest text that reads back as the same number
            line += (std::isfinite(value) ? fmt::format("{}", value) : "") + ",";
        }
        line.back() = '\n';
        text += line;
    }
    return text;
}

}  // namespace

ExportFiles csv_files(const RunData& run) {
    ExportFiles files = {{"series.csv", csv_of(run.series, series_columns())},
                         {"deposit.csv", csv_of(run.deposit, deposit_columns())}};
    if (!run.stages.empty()) files.emplace_back("stages.csv", csv_of(run.stages, stage_columns()));
    return files;
}

}  // namespace runout
