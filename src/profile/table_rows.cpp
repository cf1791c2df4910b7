#include "profile/table_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/input_error.h"

namespace runout {

std::string_view separator_text(Separator separator) {
    constexpr std::array<std::string_view, 5> texts = {"tab", "';'", "'|'", "','", "blanks"};
    return texts[static_cast<std::size_t>(separator)];
}

namespace {

constexpr std::size_t most_cells_in_a_row = 1000;
constexpr int most_lines_of_a_cell = 100;
constexpr std::size_t longest_error_word = 24;

constexpr bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

constexpr bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view hard_blank = "\xC2\xA0";
    while (!text.empty())
        if (is_blank(text.front())) {
            text.remove_prefix(1);
        } else if (text.starts_with(hard_blank)) {
            text.remove_prefix(2);
        } else if (is_blank(text.back())) {
            text.remove_suffix(1);
        } else if (text.ends_with(hard_blank)) {
            text.remove_suffix(2);
        } else {
            break;
        }
    return text;
}

/// "#N/A", "#NV", "#REF!", "#NAME?", "#DIV/0!", "####": what a spreadsheet writes where it has no number.
bool is_spreadsheet_error(std::string_view rest) {
    std::size_t end = 1;
    while (end < rest.size() &&
           ((rest[end] >= 'A' && rest[end] <= 'Z') || is_digit(rest[end]) || rest[end] == '/' ||
            rest[end] == '#' || static_cast<unsigned char>(rest[end]) >= 0x80))
        ++end;
    const std::string_view word = rest.substr(0, end);
    if (end < rest.size() && end > 2 && (rest[end] == '!' || rest[end] == '?')) return true;
    constexpr std::array<std::string_view, 6> without_a_mark = {"#N/A", "#NV",  "#N/D",
                                                                "#N/V", "#I/T", "#N/B"};
    return std::ranges::find(without_a_mark, word) != without_a_mark.end() ||
           (word.size() >= 3 && word.find_first_not_of('#') == std::string_view::npos &&
            (end == rest.size() || rest[end] != ' '));
}

char mark_of(Separator separator) {
    constexpr std::array<char, 5> marks = {'\t', ';', '|', ',', ' '};
    return marks[static_cast<std::size_t>(separator)];
}

}  // namespace

/// Walks through the text once.
class RowSplitter {
  public:
    RowSplitter(TableRows& table, std::string_view text, Separator separator, const std::string& path)
        : table_(table),
          text_(text),
          mark_(mark_of(separator)),
          by_blanks_(separator == Separator::blanks),
          path_(path) {}

    void split() {
        while (at_ < text_.size()) {
            read_row();
            if (at_ < text_.size()) ++at_;  // the line end
            ++line_;
        }
    }

  private:
    [[nodiscard]] bool at_line_end() const { return at_ >= text_.size() || text_[at_] == '\n'; }
    [[nodiscard]] bool at_mark() const { return by_blanks_ ? is_blank(text_[at_]) : text_[at_] == mark_; }

    void skip_blanks() {
        while (!at_line_end() && is_blank(text_[at_]) && (by_blanks_ || text_[at_] != mark_)) ++at_;
    }

    void skip_to_line_end() { at_ = std::min(text_.find('\n', at_), text_.size()); }

    void read_row() {
        TableRow row{line_, false, table_.cells_.size(), 0, 0};
        skip_blanks();
        if (!at_line_end() && text_[at_] == '#' && !is_spreadsheet_error(rest_of_line())) {
            row.comment = true;
            at_ = std::min(text_.find_first_not_of('#', at_), text_.size());
        }
        read_cells(row.comment);
        row.written_cells = table_.cells_.size() - row.first_cell;
        while (table_.cells_.size() > row.first_cell && table_.cells_.back().empty())
            table_.cells_.pop_back();
        row.cell_count = table_.cells_.size() - row.first_cell;
        if (row.cell_count > 0) table_.rows_.push_back(row);
    }

    void read_cells(bool in_comment) {
        for (std::size_t count = 0;; ++count) {
            if (count == most_cells_in_a_row)
                throw InputError({path_, line_, "", ""},
                                 fmt::format("has more than {} columns", most_cells_in_a_row),
                                 "give a table of points");
            skip_blanks();
            if (by_blanks_ && at_line_end()) return;
            const bool whole_row = read_cell(in_comment);
            if (whole_row || at_line_end()) return;
            ++at_;  // the mark
        }
    }

    /// True: a comment has ended the row.
    bool read_cell(bool in_comment) {
        const bool quoted = !at_line_end() && text_[at_] == '"' && !in_comment;
        if (quoted && read_quoted_cell()) return end_of_quoted_cell();
        const std::size_t begin = at_;
        while (!at_line_end() && !at_mark()) {
            if (text_[at_] == '#' && !in_comment && starts_comment(begin)) {
                add_cell(text_.substr(begin, at_ - begin));
                skip_to_line_end();
                return true;
            }
            ++at_;
        }
        add_cell(text_.substr(begin, at_ - begin));
        return false;
    }

    void add_cell(std::string_view cell) { table_.cells_.push_back(trimmed(cell)); }

    /// As much of it as a spreadsheet's error may be long.
    [[nodiscard]] std::string_view rest_of_line() const {
        const std::string_view near = text_.substr(at_, longest_error_word);
        return near.substr(0, near.find('\n'));
    }

    [[nodiscard]] bool starts_comment(std::size_t cell_begin) const {
        const bool possible = at_ == cell_begin || is_blank(text_[at_ - 1]) || is_digit(text_[at_ - 1]);
        return possible && !is_spreadsheet_error(rest_of_line());
    }

    /// From an opening quote to its closing one. False, and nothing read: what follows the closing quote
    /// shows that the quotes belong to the text.
    bool read_quoted_cell() {
        const std::size_t begin = at_ + 1;
        std::size_t end = begin;
        int lines = 0;
        bool doubled = false;
        while (true) {
            end = text_.find_first_of("\"\n", end);
            if (end == std::string_view::npos || lines > most_lines_of_a_cell)
                throw InputError({path_, line_, "", ""}, "opens a quotation that is never closed",
                                 "close it, or take the quote out");
            if (text_[end] == '\n') {
                ++lines;
                ++end;
            } else if (end + 1 < text_.size() && text_[end + 1] == '"') {
                doubled = true;
                end += 2;
            } else {
                break;
            }
        }
        const std::string_view after = trimmed(text_.substr(end + 1, 1));
        if (!after.empty() && after.front() != '\n' && after.front() != mark_ && after.front() != '#')
            return false;
        const std::string_view inside = text_.substr(begin, end - begin);
        add_cell(doubled ? std::string_view(table_.unquoted_.emplace_back(with_single_quotes(inside)))
                         : inside);
        at_ = end + 1;
        line_ += lines;
        return true;
    }

    static std::string with_single_quotes(std::string_view text) {
        std::string single;
        for (std::size_t i = 0; i < text.size(); ++i) {
            single += text[i];
            if (text[i] == '"') ++i;
        }
        return single;
    }

    bool end_of_quoted_cell() {
        skip_blanks();
        if (at_line_end() || (by_blanks_ ? text_[at_] != '#' : text_[at_] == mark_)) {
            if (by_blanks_ && !at_line_end()) --at_;  // the row goes on behind a mark
            return false;
        }
        if (text_[at_] == '#' && !is_spreadsheet_error(rest_of_line())) {
            skip_to_line_end();
            return true;
        }
        throw InputError({path_, line_, "", ""}, "has text behind a closing quote",
                         "put a separator between, or double the quotes that belong to the text");
    }

    TableRows& table_;
    std::string_view text_;
    char mark_;
    bool by_blanks_;
    const std::string& path_;
    std::size_t at_ = 0;
    int line_ = 1;
};

TableRows::TableRows(std::string_view text, Separator separator, const std::string& path) {
    RowSplitter(*this, text, separator, path).split();
}

}  // namespace runout
