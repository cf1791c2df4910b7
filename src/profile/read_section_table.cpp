#include "profile/read_section_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "core/input_error.h"
#include "core/text_file.h"
#include "profile/column_choice.h"
#include "profile/table_layout.h"
#include "profile/table_points.h"
#include "profile/table_rows.h"
#include "profile/table_text.h"

namespace runout {
namespace {

constexpr std::ptrdiff_t most_lines = 1'000'000;
constexpr std::size_t lines_of_head = 300;

/// How far a reading with one separator came: the farthest is the right one.
enum class Stage { nothing, points, columns, named_columns };

struct Attempt {
    Stage stage = Stage::nothing;
    std::optional<SectionPoints> section{};
    std::optional<InputError> error{};
};

struct TableFile {
    std::string text;
    const std::string& path;
    const TableOptions& options;
    ColumnWish wish;
};

/// The first lines: enough to see whether a separator leads anywhere.
std::string_view head_of(const std::string& text) {
    std::size_t end = 0;
    for (std::size_t line = 0; line < lines_of_head && end != std::string::npos; ++line)
        end = text.find('\n', end + 1);
    return std::string_view(text).substr(0, end);
}

bool leads_nowhere(const TableFile& file, Separator separator) {
    const std::string_view head = head_of(file.text);
    if (head.size() == file.text.size()) return false;  // the whole text is as quick
    try {
        return !find_layout(TableRows(head, separator, file.path), separator, file.wish, file.path);
    } catch (const InputError&) {
        return false;
    }
}

Attempt attempt(const TableFile& file, Separator separator) {
    Attempt made;
    if (leads_nowhere(file, separator)) return made;
    try {
        const TableRows table(file.text, separator, file.path);
        made.stage = Stage::points;
        const auto layout = find_layout(table, separator, file.wish, file.path);
        if (!layout) return {};
        made.stage = layout->by_name ? Stage::named_columns : Stage::columns;
        made.section = table_points({table, separator, *layout, file.options, file.path});
    } catch (const InputError& error) {
        made.error = error;
    }
    return made;
}

/// In the order in which they are believed.
std::vector<Separator> possible_separators(const TableFile& file) {
    using enum Separator;
    const auto holds = [&](char mark) { return file.text.find(mark) != std::string::npos; };
    std::vector<Separator> separators;
    if (holds('\t')) separators.push_back(tab);
    if (holds(';')) separators.push_back(semicolon);
    if (holds('|')) separators.push_back(bar);
    if (holds(',') && (file.options.decimal != "comma" || holds('"'))) separators.push_back(comma);
    if (holds(' ') || holds('\t')) separators.push_back(blanks);
    return separators;
}

[[noreturn]] void refuse_unreadable(const TableFile& file) {
    if (file.wish.given() && !file.wish.numbers)
        throw InputError({file.path, 0, "section.columns", file.options.columns},
                         "are not two columns of this file",
                         "name them as its header does, or give numbers: 1,2");
    throw InputError(
        {file.path, 0, "", ""}, "has no row with a chainage and an elevation",
        "give a table with a header such as chainage_m,elevation_m, or name the columns: --columns A,B "
        "(section.columns)");
}

/// The one that came farthest; another one that came as far has to agree.
SectionPoints chosen(const TableFile& file, std::vector<Attempt> attempts) {
    const auto best = std::ranges::max_element(attempts, {}, &Attempt::stage);  // the first of equals
    if (best == attempts.end() || (best->stage == Stage::nothing && !best->error)) refuse_unreadable(file);
    if (!best->section) {
        if (best->error) throw InputError(*best->error);
        refuse_unreadable(file);
    }
    for (auto other = best + 1; other != attempts.end(); ++other)
        if (other->stage == best->stage && other->section && other->section->points != best->section->points)
            throw InputError(
                {file.path, 0, "", ""},
                fmt::format("may be {}, or be {}", best->section->read_as, other->section->read_as),
                "say which: --decimal point or comma (section.decimal), or --columns A,B "
                "(section.columns)");
    return std::move(*best->section);
}

void check_length(const std::string& text, const std::string& path) {
    if (std::ranges::count(text, '\n') > most_lines)
        throw InputError({path, 0, "", ""}, fmt::format("has more than {} lines", most_lines),
                         "thin the points out: a run needs few per metre");
    if (text.find_first_not_of(" \t\n\"") == std::string::npos)
        throw InputError({path, 0, "", ""}, "is empty",
                         "give a header chainage_m,elevation_m and at least two points");
}

}  // namespace

SectionPoints section_of_table(std::string bytes, const std::string& path, const TableOptions& options) {
    const TableFile file{table_text(std::move(bytes), path), path, options,
                         column_wish(options.columns, path)};
    check_length(file.text, path);
    std::vector<Attempt> attempts;
    for (const Separator separator : possible_separators(file)) attempts.push_back(attempt(file, separator));
    return chosen(file, std::move(attempts));
}

SectionPoints read_section_table(const std::string& path, const TableOptions& options) {
    return section_of_table(read_text_file(path, "give the path of a table of chainage and elevation"), path,
                            options);
}

}  // namespace runout
