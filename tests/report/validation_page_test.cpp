#include "report/page/validation_page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace runout {
namespace {

using enum DeviationKind;

constexpr double nan = ValidationEntry::none;

ValidationEntry entry(const std::string& quantity, DeviationKind kind, double reference, double computed,
                      double accepted) {
    ValidationEntry result;
    result.quantity = quantity;
    result.held_to = "exact";
    result.reference = reference;
    result.computed = computed;
    result.kind = kind;
    result.accepted = accepted;
    return result;
}

CaseReport case_of(const std::string& name, const std::string& title) {
    CaseReport report;
    report.name = name;
    report.title = title;
    return report;
}

Figure figure_of(const std::string& name, const std::string& title) {
    Figure figure;
    figure.name = name;
    figure.title = title;
    return figure;
}

/// Every verdict and every kind once.
std::vector<CaseReport> example() {
    CaseReport column = case_of("column", "A column of sand");
    column.entries = {
        entry("front, m", relative, 2.0, 2.05, 0.05), entry("height, m", relative, 1.0, 0.8, 0.1),
        entry("time, s", absolute, 0.5, 0.52, 0.03), entry("drift", at_most, nan, 0.004, 0.001)};
    CaseReport slab = case_of("slab", "A slab on a plane");
    slab.entries = {entry("speed, m/s", relative, 1.0, 1.25, nan),
                    entry("depth, m", relative, 1.0, nan, 0.1)};
    return {column, slab};
}

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::string line_with(const std::string& text, const std::string& part) {
    for (const std::string& line : lines_of(text))
        if (line.find(part) != std::string::npos) return line;
    return {};
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::string page_of(const std::vector<CaseReport>& reports) {
    return validation_page(reports, "runout validate --page", "pictures");
}

constexpr const char* counts = "5 entries judged: 2 within their band, 3 outside; 1 reported without a band";

// ---- Terminal

TEST(ValidationTable, IsAlignedWithOneLineAnEntryAndCounts) {
    EXPECT_EQ(validation_table(example()),
              "case    quantity    measured   computed  deviation  accepted  verdict\n"
              "column  front, m           2       2.05     +2.5 %     +-5 %  pass\n"
              "column  height, m          1        0.8      -20 %    +-10 %  OUTSIDE\n"
              "column  time, s          0.5       0.52      +0.02    +-0.03  pass\n"
              "column  drift              -      0.004      0.004  <= 0.001  OUTSIDE\n"
              "slab    speed, m/s         1       1.25      +25 %         -  -\n"
              "slab    depth, m           1  no result          -    +-10 %  OUTSIDE\n"
              "\n" +
                  std::string(counts) + "\n");
}

TEST(ValidationTable, CountsNothingOfNothing) {
    EXPECT_EQ(validation_table({}),
              "0 entries judged: 0 within their band, 0 outside; 0 reported without a band\n");
}

// ---- Page

TEST(ValidationPage, CountsAndListsWhatIsOutsideBeforeAnythingElse) {
    const std::string page = page_of(example());
    const std::string top = page.substr(0, page.find("## How to read"));
    EXPECT_TRUE(has(top, counts)) << top;
    EXPECT_TRUE(has(top, "\n- column: height, m: deviation -20 %, accepted +-10 %\n")) << top;
    EXPECT_TRUE(has(top, "\n- column: drift: deviation 0.004, accepted <= 0.001\n")) << top;
    EXPECT_TRUE(has(top, "\n- slab: depth, m: no result, accepted +-10 %\n")) << top;
    EXPECT_EQ(std::ranges::count(top, '-') - std::ranges::count(top, '+'), 4) << "three entries, one sign";
    EXPECT_TRUE(has(page, "\n    runout validate --page\n"));
}

TEST(ValidationPage, SaysThatNothingIsOutside) {
    CaseReport report = case_of("a", "A");
    report.entries = {entry("x", relative, 1.0, 1.01, 0.05)};
    EXPECT_TRUE(has(page_of({report}), "## Outside their band\n\nNone.\n"));
}

TEST(ValidationPage, HasARowAnEntry) {
    std::vector<CaseReport> reports = example();
    reports[0].entries[0].scatter = 0.012344;
    reports[0].entries[0].error = 0.02;
    reports[0].entries[0].resolution = "sqrt(S)/dl = 30";
    const std::string page = page_of(reports);
    EXPECT_TRUE(has(page,
                    "\n| front, m | exact | 2 | 2.05 | 0.01234 | 0.02 | +2.5 % | +-5 % | pass | "
                    "sqrt(S)/dl = 30 |\n"));
    EXPECT_TRUE(has(page, "\n| height, m | exact | 1 | 0.8 | - | - | -20 % | +-10 % | OUTSIDE |  |\n"));
    EXPECT_TRUE(has(page, "\n| speed, m/s | exact | 1 | 1.25 | - | - | +25 % | - | - |  |\n"));
    EXPECT_TRUE(has(page, "\n## A slab on a plane\n\n[cases/slab](../cases/slab/README.md)\n"));
}

TEST(ValidationPage, DoesNotPraiseAnAgreementBelowTheErrorBar) {
    CaseReport report = case_of("a", "A");
    report.entries = {entry("praised", relative, 10.0, 10.4, 0.05),
                      entry("chance", relative, 10.0, 10.2, 0.05), entry("metres", absolute, 10.0, 9.8, 0.5)};
    for (ValidationEntry& each : report.entries) each.error = 0.3;
    const std::string page = page_of({report});
    EXPECT_TRUE(has(line_with(page, "| praised"), "| +4 % |"));
    EXPECT_TRUE(has(line_with(page, "| chance"), "| +2 % &dagger; |"));
    EXPECT_TRUE(has(line_with(page, "| metres"), "| -0.2 &dagger; |"));
    EXPECT_TRUE(has(page, "\n&dagger; smaller than the numerical error bar: agreement is not praised\n"));
    report.entries.resize(1);
    EXPECT_FALSE(has(page_of({report}), "agreement is not praised"));
}

TEST(ValidationPage, NumbersNotesAndSaysEachOnce) {
    CaseReport report = case_of("a", "A");
    report.remarks = {"A fit."};
    report.entries = {entry("p", relative, 1, 1, 1), entry("q", relative, 1, 1, 1),
                      entry("r", relative, 1, 1, 1), entry("s", relative, 1, 1, 1)};
    report.entries[1].remark = "First.";
    report.entries[2].remark = "Second,\nin two lines.";
    report.entries[3].remark = "First.";
    const std::string page = page_of({report});
    EXPECT_TRUE(has(page, "\n| p | "));
    EXPECT_TRUE(has(page, "\n| q <sup>1</sup> | "));
    EXPECT_TRUE(has(page, "\n| r <sup>2</sup> | "));
    EXPECT_TRUE(has(page, "\n| s <sup>1</sup> | "));
    EXPECT_TRUE(has(page, "\n\n1. First.\n2. Second, in two lines.\n\nA fit.\n")) << page;
}

TEST(ValidationPage, EscapesWhatWouldBreakATableOrALink) {
    CaseReport report = case_of("a", "A <b>");
    report.figures = {figure_of("f", "t [m]")};
    report.entries = {entry("|v|\nmean", relative, 1, 1, 1)};
    report.entries[0].held_to = "x < 2";
    const std::string page = page_of({report});
    EXPECT_TRUE(has(page, "\n| \\|v\\| mean | x < 2 | 1 |"));
    EXPECT_TRUE(has(page, "\n## A &lt;b>\n"));
    EXPECT_TRUE(has(page, "\n![t \\[m\\]](pictures/a-f.svg)\n"));
}

TEST(ValidationPage, EveryTableRowHasAllColumns) {
    std::size_t rows = 0;
    const std::string page = page_of(example());
    for (const std::string& line : lines_of(page.substr(page.find("## A column"))))
        if (line.starts_with("|")) {
            EXPECT_EQ(std::ranges::count(line, '|'), 11) << line;
            ++rows;
        }
    EXPECT_EQ(rows, 2 * 2 + 6u);
}

TEST(ValidationPage, LinksToExactlyThePicturesThatAreMade) {
    std::vector<CaseReport> reports = example();
    reports[0].figures = {figure_of("profile", "Profile"), figure_of("front", "Front")};
    reports[1].figures = {figure_of("front", "Speed")};
    const auto pictures = validation_pictures(reports);
    ASSERT_EQ(pictures.size(), 3u);
    EXPECT_EQ(pictures[0].first, "column-profile.svg");
    EXPECT_EQ(pictures[2].first, "slab-front.svg");
    for (const auto& [name, svg] : pictures) {
        EXPECT_TRUE(has(page_of(reports), "](pictures/" + name + ")\n")) << name;
        EXPECT_TRUE(svg.starts_with("<svg "));
    }
    EXPECT_TRUE(has(pictures[2].second, ">Speed<"));
}

}  // namespace
}  // namespace runout
