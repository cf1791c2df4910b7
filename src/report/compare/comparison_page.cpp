#include <fmt/format.h>

#include <cmath>

#include "core/printable.h"
#include "core/units.h"
#include "report/compare/comparison.h"
#include "report/page/html.h"
#include "report/page/run_page_parts.h"

namespace runout {
namespace {

constexpr double chart_low_m3 = 10, chart_high_m3 = 1e5;

double angle_of(double ratio) {
    return degrees(std::atan(ratio));
}

std::string origin_of(const TravelEstimate& estimate) {
    return estimate.second_hand ? estimate.origin + " (second-hand: the source was not read)"
                                : estimate.origin;
}

std::string run_out_words(double metres) {
    if (std::isnan(metres)) return "beyond the section";
    return metres > 0 ? fmt::format("{:.3g}", metres) : "on the cut";
}

std::string volume_words(const RunData& run, const Comparison& comparison) {
    if (std::isnan(comparison.width)) return "volume not known: give the width of the slide with --width";
    return fmt::format("volume {:.4g} m3 = {:.4g} m2 over a width of {:g} m", comparison.slide.volume,
                       run.run.measures.source_area_m2, comparison.width);
}

std::string slide_words(const RunData& run, const Comparison& comparison) {
    return fmt::format(
        "This run: reach angle {:.1f} deg, run-out {:.4g} m past the toe. H {:.4g} m and L {:.4g} m from the "
        "head of the "
        "source to the distal margin; cut of {:.1f} deg; {}.",
        comparison.angle_deg, comparison.run_out_m, comparison.slide.drop, comparison.travel_length,
        run.run.slope_angle_deg, volume_words(run, comparison));
}

std::string scatter_words() {
    const PairStatistics pairs = pair_statistics("Hong Kong");
    return fmt::format(
        "Scatter of nature: the {} Hong Kong pairs ({:g} to {:g} m3) have a mean travel angle of {:.1f} deg, "
        "between {:g} and {:g} deg; "
        "log10(H/L) scatters by +-{:.2f} (one standard deviation), that is {:.0f} % of H/L.",
        pairs.count, pairs.least_volume, pairs.greatest_volume, pairs.mean_angle_deg, pairs.least_angle_deg,
        pairs.greatest_angle_deg, pairs.scatter, 100 * (std::pow(10.0, pairs.scatter) - 1));
}

std::string error_words(const RunData& run) {
    const std::string coarse =
        fmt::format("{} particles of {:.3g} m", run.run.work.particles, run.run.work.particle_spacing_m);
    return "Numerical error of this run: " + numerical_error_words(run) + " (" + coarse + ").";
}

std::string status_of(const TravelEstimate& estimate) {
    if (!estimate.refusal.empty()) return "not applied: " + estimate.refusal;
    return estimate.caution.empty() ? "within its range: " + estimate.range
                                    : estimate.range + "; " + estimate.caution;
}

std::vector<HtmlRow> estimate_rows(const Comparison& comparison) {
    std::vector<HtmlRow> rows;
    for (std::size_t k = 0; k < comparison.estimates.size(); ++k) {
        const TravelEstimate& estimate = comparison.estimates[k];
        if (estimate.lines.empty())
            rows.push_back({text_cell(estimate.relation), text_cell("-"), text_cell("-"), text_cell("-"),
                            text_cell("-"), text_cell(status_of(estimate)), text_cell(origin_of(estimate))});
        for (std::size_t i = 0; i < estimate.lines.size(); ++i) {
            const TravelLine& line = estimate.lines[i];
            rows.push_back({text_cell(i == 0 ? estimate.relation : ""), text_cell(line.label),
                            number_cell(line.ratio, 3), number_cell(angle_of(line.ratio), 3),
                            text_cell(run_out_words(comparison.run_outs[k][i])),
                            text_cell(i == 0 ? status_of(estimate) : ""),
                            text_cell(i == 0 ? origin_of(estimate) : "")});
        }
    }
    return rows;
}

Curve pairs_of(const std::string& group, const std::string& label) {
    Curve curve{label, Curve::Style::markers, {}};
    for (const TravelPair& pair : travel_pairs())
        if (pair.group == group) curve.points.emplace_back(pair.volume, pair.angle_deg);
    return curve;
}

Curve band_curve(const VolumeBand& band) {
    constexpr int steps = 24;
    Curve curve{band.label, band.second_hand ? Curve::Style::dashed : Curve::Style::line, {}};
    for (int k = 0; k <= steps; ++k) {
        const double volume =
            band.low_volume * std::pow(band.high_volume / band.low_volume, k / double(steps));
        curve.points.emplace_back(volume, angle_of(band.coefficient * std::pow(volume, band.exponent)));
    }
    return curve;
}

/// Without a volume the run is a level line through all of them.
Curve this_run(const Comparison& comparison) {
    if (comparison.slide.volume > 0)
        return {"this run", Curve::Style::markers, {{comparison.slide.volume, comparison.angle_deg}}};
    return {"this run (volume not known)",
            Curve::Style::dashed,
            {{chart_low_m3, comparison.angle_deg}, {chart_high_m3, comparison.angle_deg}}};
}

PageChart angle_chart(const Comparison& comparison) {
    Figure figure{
        "travel-angle", "Travel angle against volume", "volume, m³", "travel angle, deg", {}, false, true};
    figure.curves.push_back(this_run(comparison));
    figure.curves.push_back(pairs_of("Hong Kong", "70 Hong Kong pairs"));
    figure.curves.push_back(pairs_of("wet, elsewhere", "wet landslides elsewhere"));
    figure.curves.push_back(pairs_of("dry", "dry landslides, mostly New Zealand, earthquakes"));
    for (const VolumeBand& band : volume_bands()) figure.curves.push_back(band_curve(band));
    return {"travel-angle", figure, false,
            "Each point is a documented landslide: the angle from the crest of its source to the toe of its "
            "deposit."};
}

}  // namespace

PageSection comparison_section(const RunData& run, const Comparison& comparison) {
    PageSection section{"comparison", "Beside what has happened before", {}, {angle_chart(comparison)}, {}};
    section.body =
        paragraph(slide_words(run, comparison)) + paragraph(scatter_words()) + paragraph(error_words(run)) +
        place_of(section.charts.front()) +
        html_table("Empirical relations",
                   {"relation", "line", "H/L", "angle, deg", "run-out, m", "range of validity", "origin"},
                   estimate_rows(comparison)) +
        paragraph(
            "Run-out: where the line from the head of the source at that angle meets this "
            "section, along the ground from the toe. The relations describe wet, "
            "three-dimensional failures; this run is plane strain.");
    return section;
}

std::string comparison_text(const RunData& run, const Comparison& comparison) {
    std::string text =
        fmt::format("run {}, {}\n{}\n{}\n{}\n\n", run.run.run_id, printable(run_title(run.run)),
                    slide_words(run, comparison), error_words(run), scatter_words());
    text += fmt::format("{:<48} {:>6} {:>7} {:>18}\n", "relation", "H/L", "angle", "run-out, m");
    std::string refused;
    for (std::size_t k = 0; k < comparison.estimates.size(); ++k) {
        const TravelEstimate& estimate = comparison.estimates[k];
        const std::string name = estimate.relation + (estimate.second_hand ? " *" : "");
        if (!estimate.refusal.empty()) refused += fmt::format("  {}: {}\n", name, estimate.refusal);
        for (std::size_t i = 0; i < estimate.lines.size(); ++i) {
            const TravelLine& line = estimate.lines[i];
            text += fmt::format("{:<48} {:>6.3f} {:>7.1f} {:>18}\n", i == 0 ? name : "    " + line.label,
                                line.ratio, angle_of(line.ratio), run_out_words(comparison.run_outs[k][i]));
        }
        if (!estimate.lines.empty()) text += fmt::format("    {}\n", status_of(estimate));
    }
    if (!refused.empty()) text += "\nNot applied:\n" + refused;
    return text + "\n* second-hand: the source itself was not read.\n";
}

std::string comparison_page(const RunData& run, const Comparison& comparison) {
    return html_page("Run-out and precedent: " + run_title(run.run),
                     fmt::format("Run {} of {}, section {}", run.run.run_id, run.run.ended_utc.substr(0, 10),
                                 run.run.section_origin),
                     {comparison_section(run, comparison), warnings_section(run), provenance_section(run)});
}

}  // namespace runout
