#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace runout {

/// What stands between the cells of a row.
enum class Separator { tab, semicolon, bar, comma, blanks };

/// For the sentence that says how a file was read: "';'", "tab".
std::string_view separator_text(Separator separator);

/// A row that is not blank, with the line that it begins on. Cells are trimmed, and empty ones at the end are
/// left out.
struct TableRow {
    int line = 0;
    bool comment = false;  ///< the whole line is one; its cells are what follows the `#`
    std::size_t first_cell = 0;
    std::size_t cell_count = 0;
    std::size_t written_cells = 0;  ///< with the empty ones at the end
};

/// The text of a table in rows and cells. A quoted cell may hold separators, line ends and doubled quotes.
/// `#` starts a comment at the beginning of a cell, or behind a blank, a digit or a quote; `#N/A` and the
/// other errors of spreadsheets are cells. Comments behind a row are left out, lines of comment are kept.
class TableRows {
  public:
    /// Keeps views of `text`, which has to outlive it. Throws InputError: a quote that is never closed, more
    /// than 1,000 cells in a row; `path` is for the message.
    TableRows(std::string_view text, Separator separator, const std::string& path);

    [[nodiscard]] const std::vector<TableRow>& rows() const { return rows_; }
    [[nodiscard]] std::span<const std::string_view> cells(const TableRow& row) const {
        return std::span(cells_).subspan(row.first_cell, row.cell_count);
    }
    /// Empty where the row has no such cell.
    [[nodiscard]] std::string_view cell(const TableRow& row, std::size_t column) const {
        return column < row.cell_count ? cells_[row.first_cell + column] : std::string_view{};
    }

  private:
    std::vector<TableRow> rows_;
    std::vector<std::string_view> cells_;
    std::deque<std::string> unquoted_;  ///< cells that are not as they stand in the text

    friend class RowSplitter;
};

}  // namespace runout
