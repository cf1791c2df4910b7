#include <algorithm>
#include <array>

#include "report/page/validation_page.h"
#include "report/text/entry_text.h"

namespace runout {
namespace {

struct Column {
    const char* title;
    bool is_word;  ///< words to the left, numbers to the right
};

constexpr std::array<Column, 7> columns = {{{"case", true},
                                            {"quantity", true},
                                            {"measured", false},
                                            {"computed", false},
                                            {"deviation", false},
                                            {"accepted", false},
                                            {"verdict", true}}};

using Line = std::array<std::string, columns.size()>;

Line line_of(const CaseReport& report, const ValidationEntry& entry) {
    return {report.name,           entry.quantity,       number_text(entry.reference), computed_text(entry),
            deviation_text(entry), accepted_text(entry), verdict_text(entry)};
}

/// Characters, not bytes, of UTF-8 text.
std::size_t letters(const std::string& text) {
    const auto begins = [](char letter) { return (static_cast<unsigned char>(letter) & 0xC0U) != 0x80U; };
    return static_cast<std::size_t>(std::ranges::count_if(text, begins));
}

std::string aligned(const std::vector<Line>& lines) {
    std::array<std::size_t, columns.size()> widths{};
    for (const Line& line : lines)
        for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], letters(line[i]));
    std::string text;
    for (const Line& line : lines) {
        std::string row;
        for (std::size_t i = 0; i < line.size(); ++i) {
            const std::string gap(widths[i] - letters(line[i]), ' ');
            row += (i == 0 ? "" : "  ") + (columns[i].is_word ? line[i] + gap : gap + line[i]);
        }
        row.erase(row.find_last_not_of(' ') + 1);
        text += row + "\n";
    }
    return text;
}

}  // namespace

std::string validation_table(std::span<const CaseReport> reports) {
    std::vector<Line> lines(1);
    for (std::size_t i = 0; i < columns.size(); ++i) lines[0][i] = columns[i].title;
    for (const CaseReport& report : reports)
        for (const ValidationEntry& entry : report.entries) lines.push_back(line_of(report, entry));
    const std::string table = lines.size() == 1 ? "" : aligned(lines) + "\n";
    return table + counts_text(reports) + "\n";
}

}  // namespace runout
