#include "report/page/validation_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/chart/svg_chart.h"
#include "report/text/entry_text.h"

namespace runout {
namespace {

constexpr const char* introduction =
    R"(How well the program computes what has been measured, or what is known exactly. All cases are computed with one set
of numerical defaults.

| column | what stands in it |
|---|---|
| held to | where the measured number comes from: an experiment, a published law, an exact solution |
| measured | that number |
| computed | ours; where there is a scatter, the mean over four jittered lattices of particles |
| scatter | standard deviation over the four lattices: what the arrangement of the particles alone changes |
| error | numerical error bar sqrt((1.25 d)^2 + scatter^2), d = difference to the mean at twice the spacing |
| deviation | computed against measured, in percent or in the unit of the quantity; where only a limit is set, the computed number |
| accepted | the band that was set for the deviation; `-`: reported without a band |
| verdict | `pass`, `OUTSIDE`, or `-` where no band is set |
| resolution | how fine the particles were |

Entries that are `OUTSIDE` their band are left in plain sight: they tell where not to trust a computed number further than
its deviation. A deviation marked &dagger; is smaller than the numerical error bar: its smallness may be chance.
)";

constexpr const char* table_head =
    "| quantity | held to | measured | computed | scatter | error | deviation | accepted | verdict | "
    "resolution |\n"
    "|---|---|---:|---:|---:|---:|---:|---:|---|---|\n";

/// One line of Markdown: line ends are spaces, and what would begin an HTML tag does not.
std::string one_line(const std::string& text) {
    std::string line;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char next = i + 1 < text.size() ? text[i + 1] : ' ';
        const bool tag = text[i] == '<' && std::string(" =<0123456789-").find(next) == std::string::npos;
        if (tag)
            line += "&lt;";
        else
            line += text[i] == '\n' || text[i] == '\r' ? ' ' : text[i];
    }
    return line;
}

std::string escaped(const std::string& text, const std::string& letters) {
    std::string result;
    for (const char letter : one_line(text)) {
        if (letters.find(letter) != std::string::npos) result += '\\';
        result += letter;
    }
    return result;
}

std::string cell(const std::string& text) {
    return escaped(text, "|\\");
}

std::string picture_name(const CaseReport& report, const Figure& figure) {
    return report.name + "-" + figure.name + ".svg";
}

bool is_below_error(const ValidationEntry& entry) {
    return std::abs(deviation(entry) * (entry.kind == DeviationKind::relative ? entry.reference : 1.0)) <
           entry.error;
}

/// Remarks of a case's entries, each once; its number is its place here plus one.
std::vector<std::string> notes_of(const CaseReport& report) {
    std::vector<std::string> notes;
    for (const ValidationEntry& entry : report.entries)
        if (!entry.remark.empty() && std::ranges::find(notes, entry.remark) == notes.end())
            notes.push_back(entry.remark);
    return notes;
}

std::string note_mark(const ValidationEntry& entry, const std::vector<std::string>& notes) {
    const auto note = std::ranges::find(notes, entry.remark);
    return note == notes.end() ? "" : fmt::format(" <sup>{}</sup>", note - notes.begin() + 1);
}

std::string row(const ValidationEntry& entry, const std::vector<std::string>& notes) {
    return fmt::format("| {}{} | {} | {} | {} | {} | {} | {}{} | {} | {} | {} |\n", cell(entry.quantity),
                       note_mark(entry, notes), cell(entry.held_to), number_text(entry.reference),
                       computed_text(entry), number_text(entry.scatter), number_text(entry.error),
                       deviation_text(entry), is_below_error(entry) ? " &dagger;" : "", accepted_text(entry),
                       verdict_text(entry), cell(entry.resolution));
}

std::string table(const CaseReport& report) {
    if (report.entries.empty()) return {};
    const std::vector<std::string> notes = notes_of(report);
    std::string text = "\n";
    text += table_head;
    for (const ValidationEntry& entry : report.entries) text += row(entry, notes);
    if (std::ranges::any_of(report.entries, is_below_error))
        text += "\n&dagger; smaller than the numerical error bar: agreement is not praised\n";
    if (!notes.empty()) text += "\n";
    for (std::size_t i = 0; i < notes.size(); ++i) text += fmt::format("{}. {}\n", i + 1, one_line(notes[i]));
    return text;
}

std::string section(const CaseReport& report, const std::string& picture_folder) {
    std::string text =
        fmt::format("\n## {0}\n\n[cases/{1}](../cases/{1}/README.md)\n", one_line(report.title), report.name);
    text += table(report);
    for (const std::string& remark : report.remarks) text += fmt::format("\n{}\n", one_line(remark));
    for (const Figure& figure : report.figures)
        text += fmt::format("\n![{}]({}/{})\n", escaped(figure.title, "[]\\"), picture_folder,
                            picture_name(report, figure));
    return text;
}

std::string outside_list(std::span<const CaseReport> reports) {
    std::string lines;
    for (const CaseReport& report : reports)
        for (const ValidationEntry& entry : report.entries)
            if (is_outside(entry))
                lines += fmt::format("- {}: {}: {}, accepted {}\n", report.name, one_line(entry.quantity),
                                     std::isfinite(entry.computed) ? "deviation " + deviation_text(entry)
                                                                   : computed_text(entry),
                                     accepted_text(entry));
    return "## Outside their band\n\n" + (lines.empty() ? "None.\n" : lines);
}

}  // namespace

std::string validation_page(std::span<const CaseReport> reports, const std::string& command,
                            const std::string& picture_folder) {
    std::string text = fmt::format("# Validation\n\n{}.\n\n{}", counts_text(reports), outside_list(reports));
    text += fmt::format("\n## How to read this page\n\n{}\nThis page is made by\n\n    {}\n", introduction,
                        command);
    for (const CaseReport& report : reports) text += section(report, picture_folder);
    return text;
}

std::vector<std::pair<std::string, std::string>> validation_pictures(std::span<const CaseReport> reports) {
    std::vector<std::pair<std::string, std::string>> pictures;
    for (const CaseReport& report : reports)
        for (const Figure& figure : report.figures)
            pictures.emplace_back(picture_name(report, figure), svg_chart(figure));
    return pictures;
}

}  // namespace runout
