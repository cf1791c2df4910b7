#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "report/text/run_out_table.h"
#include "store/store.h"

namespace runout {

/// What the study varied, an object. Throws InputError where the stored text is none.
nlohmann::ordered_json inputs_of(const StudyRow& row);

/// A row of the study with its inputs read.
struct StudyEntry {
    const StudyRow* row = nullptr;
    std::map<std::string, std::string> inputs;  ///< as labels
    std::map<std::string, double> numbers;      ///< those that are numbers
};

std::vector<StudyEntry> entries_of(const std::vector<StudyRow>& rows);

/// Numbers by size, then words.
struct LabelOrder {
    bool operator()(const std::string& a, const std::string& b) const;
};
using StudyLabels = std::set<std::string, LabelOrder>;

/// What a word says of the scenarios that ran.
StudyLabels labels_of(const std::vector<StudyEntry>& entries, const std::string& word);

/// The words that rows and columns stand for.
struct StudyLayout {
    std::string rows, columns;
};

/// As asked for, or chosen by what varies. Throws InputError, see run_out_table.
StudyLayout layout_of(const std::vector<StudyEntry>& entries, const RunOutTableOptions& options);

/// The results that share a row and a column.
struct StudyCell {
    std::vector<const StudyRow*> runs;

    /// Distance that a run of the cell reaches or passes with this probability, m.
    [[nodiscard]] double reached(double probability) const;
};

/// By row, then by column, as the table shows them.
struct CellOrder {
    bool operator()(const std::pair<std::string, std::string>& a,
                    const std::pair<std::string, std::string>& b) const;
};
using StudyCells = std::map<std::pair<std::string, std::string>, StudyCell, CellOrder>;

StudyCells cells_of(const std::vector<StudyEntry>& entries, const StudyLayout& layout);

}  // namespace runout
