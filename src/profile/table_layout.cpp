#include "profile/table_layout.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/input_error.h"
#include "profile/table_numbers.h"

namespace runout {
namespace {

constexpr std::size_t most_lines_above_points = 200;
constexpr const char* name_the_columns =
    "give --columns A,B (section.columns): names or numbers of the columns of chainage and elevation";

using Cells = std::span<const std::string_view>;

bool is_numeric(std::string_view cell) {
    return mark_evidence(cell) != MarkEvidence::no_number || station_text(cell).has_value();
}

/// A row of numbers, and perhaps holes, which are to be seen and not to be taken for a title.
bool is_all_numeric(const TableRow& row, Cells cells) {
    const bool some = std::ranges::any_of(cells, is_numeric);
    return some && row.written_cells >= 2 &&
           std::ranges::all_of(cells, [](std::string_view c) { return is_numeric(c) || says_nothing(c); });
}

/// One number is enough: a hole beside it is to be seen, and not to be taken for a title.
bool is_point(const TableRows& table, const TableRow& row, const ColumnPair& columns) {
    return is_numeric(table.cell(row, columns.first)) || is_numeric(table.cell(row, columns.second));
}

/// Where blanks separate, "Elev (US ft)" is one name: what opens a bracket is joined up to its end.
std::vector<std::string> header_cells(Cells cells, Separator separator) {
    std::vector<std::string> joined;
    bool open = false;
    for (const std::string_view cell : cells) {
        const bool bracket = !cell.empty() && (cell.front() == '(' || cell.front() == '[');
        if (separator == Separator::blanks && !joined.empty() && (open || bracket)) {
            joined.back() += fmt::format(" {}", cell);
        } else {
            joined.emplace_back(cell);
        }
        const std::string& last = joined.back();
        open = std::ranges::count(last, '(') > std::ranges::count(last, ')') ||
               std::ranges::count(last, '[') > std::ranges::count(last, ']');
    }
    return joined;
}

std::vector<ColumnName> column_names(Cells cells, Separator separator) {
    std::vector<ColumnName> names;
    for (const std::string& cell : header_cells(cells, separator)) names.push_back(column_name(cell));
    return names;
}

/// Goes down the rows until the first point.
class LayoutSearch {
  public:
    LayoutSearch(const TableRows& table, Separator separator, const ColumnWish& wish, const std::string& path)
        : table_(table), separator_(separator), wish_(wish), path_(path) {}

    std::optional<TableLayout> find() {
        const auto& rows = table_.rows();
        for (std::size_t i = 0; i < std::min(rows.size(), most_lines_above_points); ++i) {
            if (is_first_point(rows[i])) return layout_from(i);
            if (rows[i].comment || !take_header(i)) continue;
            header_ = i;
        }
        if (columns_ && header_)
            throw InputError({path_, rows[*header_].line, "", ""}, "has a header but no points",
                             "a section needs at least two points");
        return std::nullopt;
    }

  private:
    [[nodiscard]] bool is_first_point(const TableRow& row) const {
        if (row.comment) return false;
        if (wish_.numbers) return is_point_by_number(row);
        if (columns_) return is_point(table_, row, *columns_);
        return !wish_.given() && is_all_numeric(row, table_.cells(row));
    }

    [[nodiscard]] bool is_point_by_number(const TableRow& row) const {
        const std::string_view chainage = table_.cell(row, wish_.numbers->first);
        const std::string_view elevation = table_.cell(row, wish_.numbers->second);
        return (is_numeric(chainage) && (is_numeric(elevation) || says_nothing(elevation))) ||
               (says_nothing(chainage) && is_numeric(elevation));
    }

    /// True: the row names the columns.
    bool take_header(std::size_t i) {
        const TableRow& row = table_.rows()[i];
        std::vector<ColumnName> names = column_names(table_.cells(row), separator_);
        if (wish_.numbers) {
            const bool named = std::max(wish_.numbers->first, wish_.numbers->second) < names.size() &&
                               !names[wish_.numbers->first].plain.empty() &&
                               !names[wish_.numbers->second].plain.empty();
            if (named) names_ = std::move(names);
            return named;
        }
        const auto columns = named_columns(names, wish_, {path_, row.line, "header", ""});
        if (!columns) return false;
        columns_ = columns;
        names_ = std::move(names);
        return true;
    }

    TableLayout layout_from(std::size_t first) {
        if (!columns_ && !wish_.given()) take_header_from_comments(first);
        if (wish_.numbers) columns_ = wish_.numbers;
        if (!header_) refuse_points_above(first);
        if (!columns_) columns_ = the_only_two(first);
        TableLayout layout;
        layout.first_row = first;
        layout.header_cells = names_.size();
        layout.by_name = header_.has_value() && !wish_.numbers;
        layout.chainage.index = columns_->first;
        layout.elevation.index = columns_->second;
        if (!names_.empty()) {
            layout.chainage.name = with_unit_below(columns_->first, first);
            layout.elevation.name = with_unit_below(columns_->second, first);
        }
        layout.titles_mention_feet = feet_above(first);
        return layout;
    }

    /// Programs that write numbers often put the header behind a `#`.
    void take_header_from_comments(std::size_t first) {
        const std::size_t width = table_.rows()[first].cell_count;
        for (std::size_t i = 0; i < first; ++i) {
            const TableRow& row = table_.rows()[i];
            if (!row.comment || header_cells(table_.cells(row), separator_).size() != width) continue;
            if (take_header(i)) header_ = i;
        }
    }

    /// A table without a header has chainage and elevation, in this order, and nothing else.
    [[nodiscard]] ColumnPair the_only_two(std::size_t first) const {
        const TableRow& row = table_.rows()[first];
        std::vector<std::size_t> filled;
        for (std::size_t i = 0; i < row.cell_count; ++i)
            if (!table_.cell(row, i).empty()) filled.push_back(i);
        for (std::size_t i = 0; i < first; ++i) refuse_unknown_header(table_.rows()[i], row);
        if (filled.size() != 2)
            throw InputError({path_, row.line, "", ""},
                             fmt::format("begins {} columns that no header names", filled.size()),
                             name_the_columns);
        return {filled[0], filled[1]};
    }

    /// Without a header, a row that looks like half a point is not to pass for a title.
    void refuse_points_above(std::size_t first) const {
        for (std::size_t i = 0; i < first; ++i) {
            const TableRow& row = table_.rows()[i];
            const Cells cells = table_.cells(row);
            const bool begins_alike =
                row.written_cells >= table_.rows()[first].cell_count && is_numeric(cells.front());
            if (!row.comment && (begins_alike || std::ranges::count_if(cells, is_numeric) >= 2))
                throw InputError({path_, row.line, "", ""}, "is neither a header nor a point",
                                 "take the line out, or name the columns: --columns A,B (section.columns)");
        }
    }

    void refuse_unknown_header(const TableRow& row, const TableRow& point) const {
        const Cells cells = table_.cells(row);
        const bool alike = !row.comment && row.cell_count == point.cell_count && row.cell_count >= 2 &&
                           std::ranges::none_of(cells, is_numeric);
        if (!alike) return;
        throw InputError({path_, row.line, "header", ""},
                         fmt::format("names the columns {}, and not both chainage and elevation",
                                     listed_names(column_names(cells, separator_))),
                         name_the_columns);
    }

    /// A unit often stands in a row of its own below the names.
    [[nodiscard]] ColumnName with_unit_below(std::size_t column, std::size_t first) const {
        ColumnName name = names_[column];
        for (std::size_t i = *header_ + 1; i < first && !name.unit && !name.strange_unit; ++i) {
            if (table_.rows()[i].comment) continue;
            const ColumnName below = unit_cell(table_.cell(table_.rows()[i], column));
            name.unit = below.unit;
            name.strange_unit = below.strange_unit;
        }
        return name;
    }

    [[nodiscard]] bool feet_above(std::size_t first) const {
        for (std::size_t i = 0; i < first; ++i)
            for (const std::string_view cell : table_.cells(table_.rows()[i]))
                if (mentions_feet(cell)) return true;
        return false;
    }

    const TableRows& table_;
    Separator separator_;
    const ColumnWish& wish_;
    const std::string& path_;
    std::optional<ColumnPair> columns_;
    std::optional<std::size_t> header_;
    std::vector<ColumnName> names_;
};

}  // namespace

std::optional<TableLayout> find_layout(const TableRows& table, Separator separator, const ColumnWish& wish,
                                       const std::string& path) {
    return LayoutSearch(table, separator, wish, path).find();
}

}  // namespace runout
