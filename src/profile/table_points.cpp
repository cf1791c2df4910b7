#include "profile/table_points.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/input_error.h"
#include "profile/check_elevations.h"
#include "profile/table_decimal.h"
#include "profile/table_numbers.h"
#include "profile/table_units.h"

namespace runout {
namespace {

constexpr const char* no_holes = "survey it, or take the whole row out where the ground between is straight";

std::string column_label(const TableColumn& column) {
    return column.name.text.empty() ? fmt::format("column {}", column.index + 1) : column.name.text;
}

/// Reads one table: cells, then numbers, then their order.
class PointReader {
  public:
    explicit PointReader(const TableReading& reading)
        : reading_(reading), layout_(reading.layout), path_(reading.path) {}

    SectionPoints read() {
        take_cells();
        mark_ = decimal_mark();
        units_ = table_units(reading_, cells_);
        for (const PointCells& cells : cells_) add_point(cells);
        drop_repeated_end();
        if (section_.points.size() < 2)
            throw InputError({path_, section_.lines.front(), "", ""}, "has one point only",
                             "a section needs at least two points");
        put_in_order();
        section_.origin = path_;
        section_.read_as = is_strict() ? "" : read_as();
        check_elevations(section_);
        return std::move(section_);
    }

  private:
    [[nodiscard]] DecimalMark decimal_mark() const {
        const std::string& said = reading_.options.decimal;
        if (said.empty()) return decimal_mark_of(cells_, reading_.separator, path_);
        return said == "comma" ? DecimalMark::comma : DecimalMark::point;
    }

    void take_cells() {
        const auto& rows = reading_.table.rows();
        for (std::size_t i = layout_.first_row; i < rows.size(); ++i) {
            const TableRow& row = rows[i];
            if (row.comment) continue;
            check_width(row, rows[layout_.first_row]);
            cells_.push_back({row.line, reading_.table.cell(row, layout_.chainage.index),
                              reading_.table.cell(row, layout_.elevation.index)});
        }
    }

    /// A row wider than the others may be one whose decimal commas, or blanks between thousands, were taken
    /// for separators.
    void check_width(const TableRow& row, const TableRow& first) const {
        const std::size_t count = row.cell_count;
        const bool few = row.written_cells <= std::max(layout_.chainage.index, layout_.elevation.index);
        const bool named = layout_.header_cells > 0;
        const bool by_commas = reading_.separator == Separator::comma;
        const bool by_blanks = reading_.separator == Separator::blanks;
        if (few || (named && by_commas && count > layout_.header_cells))
            throw InputError({path_, row.line, "", ""},
                             fmt::format("has {} field{}", count, count == 1 ? "" : "s"), wanted_fields(few));
        // Where blanks separate, a name of two words looks like two columns.
        if (by_blanks && layout_.by_name && count != layout_.header_cells)
            throw InputError({path_, row.line, "", ""},
                             fmt::format("has {} words below a header of {}", count, layout_.header_cells),
                             "give each row the same columns, or name them by numbers: --columns A,B "
                             "(section.columns)");
        const bool like_first = count == first.cell_count || row.written_cells == first.written_cells;
        if (((by_commas && !named) || by_blanks) && !like_first)
            throw InputError(
                {path_, row.line, "", ""},
                fmt::format("has {} fields, and line {} has {}", count, first.line, first.cell_count),
                "give each row the same columns");
    }

    [[nodiscard]] std::string wanted_fields(bool few) const {
        const std::string& columns = reading_.options.columns;
        if (few && !columns.empty())
            return fmt::format("the columns {} that section.columns names are to be in each row", columns);
        return layout_.header_cells > 0 ? fmt::format("the header names {}", layout_.header_cells)
                                        : "give a chainage and an elevation";
    }

    [[nodiscard]] double number(std::string_view cell, const TableColumn& column, int line) const {
        const InputPlace place{path_, line, column_label(column), std::string(cell)};
        if (cell.empty()) throw InputError(place, "is empty", no_holes);
        if (says_nothing(cell)) throw InputError(place, "says that there is no value", no_holes);
        if (const auto value = number_of(cell, mark_)) return *value;
        const bool readable = mark_evidence(cell) != MarkEvidence::no_number;
        const bool finite = number_of(cell, DecimalMark::point) || number_of(cell, DecimalMark::comma);
        throw InputError(
            place, readable && !finite ? "is not a finite number" : "is not a number",
            mark_ == DecimalMark::point ? "give a number, such as 12.5" : "give a number, such as 12,5");
    }

    [[nodiscard]] double chainage(const PointCells& cells) const {
        if (!units_.station_digits) return number(cells.chainage, layout_.chainage, cells.line);
        const auto station = station_text(cells.chainage);
        if (!station || station->digits_after != *units_.station_digits)
            throw InputError({path_, cells.line, column_label(layout_.chainage), std::string(cells.chainage)},
                             "is not written as the stations above it", "write all of them alike");
        const double before = number(station->before, layout_.chainage, cells.line);
        const double along = before * (*units_.station_digits == 3 ? 1000 : 100) +
                             number(station->after, layout_.chainage, cells.line);
        return station->sign.empty() ? along : -along;
    }

    void add_point(const PointCells& cells) {
        const double along = chainage(cells);
        const double elevation = number(cells.elevation, layout_.elevation, cells.line);
        if (is_nodata_number(elevation))
            throw InputError(
                {path_, cells.line, column_label(layout_.elevation), std::string(cells.elevation)},
                "stands for missing data", no_holes);
        section_.points.emplace_back(along * units_.chainage.metres, elevation * units_.elevation.metres);
        section_.lines.push_back(cells.line);
    }

    void drop_repeated_end() {
        auto& points = section_.points;
        while (points.size() >= 2 && points.back() == points[points.size() - 2]) {
            remarks_ += fmt::format(", line {} left out as it repeats the last point", section_.lines.back());
            points.pop_back();
            section_.lines.pop_back();
        }
    }

    /// A survey may have gone either way, and never back and forth.
    void put_in_order() {
        const auto& points = section_.points;
        std::size_t forth = 0;
        std::size_t back = 0;
        for (std::size_t i = 1; i < points.size(); ++i) {
            forth += points[i].x() > points[i - 1].x() ? 1 : 0;
            back += points[i].x() < points[i - 1].x() ? 1 : 0;
        }
        const bool descending = back > forth;
        for (std::size_t i = 1; i < points.size() && forth > 0 && back > 0; ++i)
            if (descending ? points[i].x() > points[i - 1].x() : points[i].x() < points[i - 1].x())
                refuse_order(i, descending);
        if (!descending) return;
        std::ranges::reverse(section_.points);
        std::ranges::reverse(section_.lines);
        remarks_ += ", rows reversed as their chainage falls";
    }

    [[noreturn]] void refuse_order(std::size_t i, bool descending) const {
        const std::string_view cell = cell_at_line(section_.lines[i]);
        const std::string_view before = cell_at_line(section_.lines[i - 1]);
        throw InputError({path_, section_.lines[i], column_label(layout_.chainage), std::string(cell)},
                         descending ? fmt::format("rises behind {}, though most chainages fall", before)
                                    : fmt::format("goes back behind {}, which is an overhang", before),
                         "sort the points along the section, or name the columns: --columns A,B");
    }

    [[nodiscard]] std::string_view cell_at_line(int line) const {
        return std::ranges::find(cells_, line, &PointCells::line)->chainage;
    }

    /// The form that needs no telling.
    [[nodiscard]] bool is_strict() const {
        const TableOptions& said = reading_.options;
        return layout_.chainage.name.text == "chainage_m" && layout_.elevation.name.text == "elevation_m" &&
               layout_.header_cells == 2 && reading_.separator == Separator::comma && remarks_.empty() &&
               said.columns.empty() && said.unit.empty() && said.decimal.empty();
    }

    [[nodiscard]] std::string read_as() const {
        const auto column = [](const TableColumn& of) {
            return fmt::format("from column {}{}", of.index + 1,
                               of.name.text.empty() ? "" : fmt::format(" '{}'", of.name.text));
        };
        return fmt::format("read as: chainage {}, elevation {}, separator {}, decimal {}, {}{}",
                           column(layout_.chainage), column(layout_.elevation),
                           separator_text(reading_.separator),
                           mark_ == DecimalMark::point ? "point" : "comma", units_.text, remarks_);
    }

    const TableReading& reading_;
    const TableLayout& layout_;
    const std::string& path_;
    std::vector<PointCells> cells_;
    DecimalMark mark_ = DecimalMark::point;
    TableUnits units_;
    SectionPoints section_;
    std::string remarks_;
};

}  // namespace

SectionPoints table_points(const TableReading& reading) {
    return PointReader(reading).read();
}

}  // namespace runout
