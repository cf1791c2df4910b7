#include "report/page/accuracy_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/text/ladder_text.h"

namespace runout {
namespace {

constexpr const char* introduction = R"(# What accuracy costs in time

A finer run is a better run, up to a point, and costs about eight times as much for half the spacing. This page says what a
percent of the run-out costs on five scenes, where paying more buys nothing, and whether `runout run` kept the promise that its
error bars make. All seconds are CPU seconds of one run on one thread of

    {}

The error is the *numerical* one: what a run with ever finer particles would still change, with 95 % confidence. It says nothing of
whether the soil, the shape of the source or plane strain are right. Empirical relations of travel distance scatter by about
0.16 in log10(H/L), a factor of 1.4 either way; beside that, a numerical error below 5 % is rarely worth its time.

This page is made from a database of studies, one for each scene:

    runout accuracy CASE --target 1% --finest 64 --lattices 8 --budget 600 --methods --check --threads 1 --db accuracy.db
    runout accuracy --db accuracy.db --page docs/accuracy.md

)";

constexpr const char* promises = R"(
## Do chosen settings keep their promise?

For each scene and target, `runout run` was left to choose: once from pilot runs, without this scene's
own ladder and with the survey of shipped ladders *without this scene*, and once from its own ladder, a
rung of which the run then repeats. The finest rung lies within the stated error bar in {} of {} runs;
choosing took at most half the time of the run in {} of {}; the time was foretold within a factor of 1.5
in {} of {}. The runs chosen from a ladder are among those that its error bars were made from, so that only
those chosen from pilots are a test of the bars. Spacings between the rungs are not offered: bars there are
too short.

)";

constexpr const char* how_to_read = R"(
## How to read the scenes

*sqrt(S)/dl* is the number of particles along the square root of the area of the source. Each rung of a ladder is run on the regular
lattice and on lattices that start off it at random; numbers are means, and what stands after +- is the standard deviation of one
lattice: what the arrangement of the particles alone changes, and no refinement of a single run removes.
*off the finest* compares with the mean of the finest rung. The *error bar* is that of one run, 95 %: the error of the spacing and twice the
greatest scatter of the three rungs near it, as root of squares. The error of the spacing is the range of the finest rungs where they differ by
no more than chance; else it comes from the least-squares form of the convergence where that finds an order (Eca and Hoekstra 2014),
else of first order from the finest rung and the one twice as coarse, with the safety factor 1.25 of the grid convergence index.
A run without a ladder of its own takes the worst of the shipped ladders at its spacing: the distance from the finest rung, what that
one may still be off for its spacing, and twice the scatter, as root of squares; more where pilots change more than any of them did.

The charts show the error of a single run (root mean square over lattices, against the finest rung) over its cost. The line
*spacing* is the ladder with the default settings; the other lines turn one knob each at one spacing. A line that runs to the right
without falling is a knob that costs time and buys nothing; one that lies below the line *spacing* would be worth turning.
)";

std::string cost_text(const Price& price) {
    if (!price.met)
        return fmt::format("not to be had: {:.1f} % at best",
                           100.0 * price.error_m * price.target_share / price.target_m);
    return fmt::format("{} (sqrt(S)/dl = {:g}{})", short_duration(price.cost.cpu_s), price.resolution,
                       price.beyond_ladder ? ", extrapolated" : "");
}

/// A sentence for people: from where on more time buys nothing.
std::string where_it_stops(const AccuracyStudy& study) {
    const Convergence& c = study.ladder.convergence[0];
    const double floor = 200.0 * c.scatter / reference_of(study.ladder).scale_m;
    return fmt::format("{}; below {:.1f} % one run is at the mercy of its lattice", to_string(c.verdict),
                       floor);
}

std::string price_table(std::span<const AccuracyStudy> studies) {
    std::string text =
        "| scene | 10 % costs | 5 % costs | 2 % costs | 1 % costs | where it stops paying "
        "|\n|---|---|---|---|---|---|\n";
    for (const AccuracyStudy& study : studies) {
        text += fmt::format("| {} |", study.name);
        for (const Price& price : study.prices) text += fmt::format(" {} |", cost_text(price));
        text += fmt::format(" {} |\n", where_it_stops(study));
    }
    return text;
}

struct Score {
    int kept = 0, all = 0;
    void count(bool good) {
        kept += good ? 1 : 0;
        ++all;
    }
};

bool well_foretold(const StoredRun& run) {
    const double ratio = run.work.cpu_s / run.appraisal.expected_cpu_s;
    return ratio <= 1.5 && ratio >= 1.0 / 1.5;
}

std::string choice_row(const AccuracyStudy& study, const ChoiceCheck& check) {
    const StoredRun& run = check.run;
    const double scale = reference_of(study.ladder).scale_m;
    return fmt::format("| {} | {} | {} | {:g} | {:.1f} | {:+.1f} | {} | {:.2g} | {:.2g} | {:.2g} |\n",
                       study.name, check.target, run.appraisal.error_origin, check.resolution,
                       100.0 * run.appraisal.run_out_error_m / scale, 100.0 * check.off_finest_m / scale,
                       check.inside ? "yes" : "**no**", run.appraisal.choosing_cpu_s,
                       run.appraisal.expected_cpu_s, run.work.cpu_s);
}

std::string choices(std::span<const AccuracyStudy> studies) {
    std::string rows;
    Score inside, cheap, foretold;
    for (const AccuracyStudy& study : studies)
        for (const ChoiceCheck& check : study.choices) {
            rows += choice_row(study, check);
            inside.count(check.inside);
            cheap.count(check.run.appraisal.choosing_cpu_s <= 0.5 * check.run.work.cpu_s);
            foretold.count(well_foretold(check.run));
        }
    if (rows.empty()) return {};
    return fmt::format(promises, inside.kept, inside.all, cheap.kept, cheap.all, foretold.kept,
                       foretold.all) +
           "| scene | target | from | sqrt(S)/dl | stated error, % | off the finest, % | inside | choosing, "
           "s | "
           "foretold, s | took, s |\n|---|---|---|---:|---:|---:|---|---:|---:|---:|\n" +
           rows;
}

std::string spread(const RungValue& value) {
    if (value.lattices < 2) return fmt::format("{:.4g}", value.mean);
    return fmt::format("{:.4g} +-{:.1g}", value.mean, value.scatter);
}

std::string ladder_table(const Ladder& ladder) {
    const Reference reference = reference_of(ladder);
    std::string text =
        "| sqrt(S)/dl | dl, m | particles | steps | iterations a step | CPU, s | memory, MB | run-out, m | "
        "reach "
        "angle, deg | deposit height, m | off the finest, % | error bar, % |\n"
        "|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";
    for (const RungSummary& rung : ladder.rungs) {
        if (rung.results == 0) {
            text += fmt::format("| {:g} | {:.3g} | {:.0f} | failed: {} |\n", rung.resolution, rung.spacing_m,
                                rung.cost.particles, rung.failure);
            continue;
        }
        const double bar = error_bar(ladder.convergence[0], rung.spacing_m);
        text += fmt::format(
            "| {:g} | {:.3g} | {:.0f} | {:.0f} | {:.1f} | {:.2g} | {:.0f} | {} | {} | {} | {:+.1f} | {:.1f} "
            "|\n",
            rung.resolution, rung.spacing_m, rung.cost.particles, rung.cost.steps,
            rung.cost.pressure_iterations / std::max(1.0, rung.cost.steps), rung.cost.cpu_s,
            rung.cost.peak_memory_mb, spread(rung.values[0]), spread(rung.values[1]), spread(rung.values[2]),
            100.0 * (rung.values[0].mean - reference.run_out_m) / reference.scale_m,
            100.0 * bar / reference.scale_m);
    }
    return text;
}

std::string verdict_table(const Ladder& ladder) {
    std::string text =
        "\n| quantity | verdict | order of the three finest | Richardson value | GCI, % | least-squares "
        "order | "
        "least-squares value | one run on the finest rung |\n|---|---|---:|---:|---:|---:|---:|---:|\n";
    for (std::size_t q = 0; q < ladder_quantities.size(); ++q) {
        const Convergence& c = ladder.convergence[q];
        const bool order = c.fit && std::isfinite(c.fit->observed_order);
        text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {:.4g} +-{:.2g} |\n",
                            ladder_quantities[q].title, to_string(c.verdict),
                            c.finest_three ? fmt::format("{:.2f}", c.finest_three->order) : "-",
                            c.finest_three ? fmt::format("{:.4g}", c.finest_three->extrapolated) : "-",
                            c.finest_three ? fmt::format("{:.2g}", 100.0 * c.finest_three->gci) : "-",
                            order ? fmt::format("{:.2f}", c.fit->observed_order) : "-",
                            c.fit ? fmt::format("{:.4g}", c.fit->value) : "-", c.finest_value, c.uncertainty);
    }
    return text;
}

std::string failures(const AccuracyStudy& study) {
    std::string text;
    for (const MethodPoint& point : study.points)
        if (!point.failure.empty())
            text += fmt::format("- {} = {}: {}\n", point.series, point.setting, point.failure);
    return text.empty() ? text : "\nFailed settings:\n\n" + text;
}

std::string scene_section(const AccuracyStudy& study, const std::string& picture_folder) {
    return fmt::format("\n## {0}\n\n{1}{2}\n![{3}]({4}/{0}.svg)\n{5}", study.name, ladder_table(study.ladder),
                       verdict_table(study.ladder), chart_title(study.name), picture_folder, failures(study));
}

}  // namespace

std::string chart_title(const std::string& scene) {
    return scene + ": error of the run-out against CPU time";
}

std::string accuracy_page(std::span<const AccuracyStudy> studies, const std::string& picture_folder) {
    const std::string machine = studies.empty() ? "" : studies.front().machine;
    std::string text = fmt::format(fmt::runtime(introduction), machine);
    text += price_table(studies) + choices(studies) + how_to_read;
    for (const AccuracyStudy& study : studies) text += scene_section(study, picture_folder);
    return text;
}

}  // namespace runout
