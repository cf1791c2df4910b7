#include "report/page/run_page.h"

#include <fmt/format.h>

#include "report/compare/comparison.h"
#include "report/page/html.h"
#include "report/page/run_page_parts.h"

namespace runout {
namespace {

using MakeSection = PageSection (*)(const RunData&);

// In the order of the page, with the comparison between them.
constexpr MakeSection before_comparison[] = {
    answer_section,  warnings_section, picture_section, animation_section, motion_section,
    deposit_section, envelope_section, places_section,  stages_section,    accuracy_section,
};
constexpr MakeSection after_comparison[] = {effects_section, inputs_section, further_section,
                                            provenance_section};

PageSection comparison_part(const RunData& run, double width) {
    const std::string refusal = comparison_refusal(run);
    if (refusal.empty()) return comparison_section(run, compare_run(run, width));
    return {"comparison",
            "Beside what has happened before",
            paragraph("This run is not compared with documented landslides: " + refusal + "."),
            {},
            {}};
}

}  // namespace

std::string run_page(const RunData& run, double width) {
    std::vector<PageSection> parts;
    for (const MakeSection make : before_comparison) parts.push_back(make(run));
    parts.push_back(comparison_part(run, width));
    for (const MakeSection make : after_comparison) parts.push_back(make(run));
    return html_page("Run-out: " + run_title(run.run),
                     fmt::format("Run {} of {}, section {}", run.run.run_id, run.run.ended_utc.substr(0, 10),
                                 run.run.section_origin),
                     parts);
}

}  // namespace runout
