#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "validation/slopes_boxes.h"
#include "validation/slopes_shared.h"

namespace runout::slopes {
namespace {

constexpr double coarse_band = 0.05;  // of a front at 1.5 mm to that at 0.6 mm

double root_area() {
    return std::sqrt(box_length * box_thickness);
}

struct Front {
    const char* what;
    double Measures::*value;
};

constexpr Front fronts[] = {{"front, 99.5 % of the mass, m", &Measures::front_mass_995_m},
                            {"front by top, m", &Measures::front_by_top_m},
                            {"front by mass, m", &Measures::front_by_mass_m}};

/// Mean over the coarse half of the ensemble, which has none of its own to tell an error bar.
Estimate coarse_mean(const CaseRuns& runs, const std::string& id, double Measures::*value) {
    if (!all_are_results(runs, coarse_lattices_of(id))) return {};
    std::vector<double> values;
    for (const std::string& run : coarse_lattices_of(id)) values.push_back(runs.run(run).measures.*value);
    Estimate mean = estimate_of(values, values);
    mean.error = ValidationEntry::none;
    return mean;
}

void add_fronts(CaseReport& report, const CaseRuns& runs, bool quick) {
    const double spacing = spacing_of(quick);
    for (const Front& front : fronts) {
        ReferenceValue finest{};
        if (finest_is_there(runs, quick)) {
            finest = {"own run, dl = 0.6 mm", runs.run(finest_run).measures.*front.value};
            report.entries.push_back(held(exact(finest.value), front.what, {}, at_spacing(finest_spacing)));
        }
        const Estimate coarse = coarse_mean(runs, "head", front.value);
        report.entries.push_back(held(coarse, front.what, finest, at_spacing(2.0 * spacing)));
        if (!quick) finest.accepted = coarse_band;
        report.entries.push_back(
            held(measured(runs, "head", front.value), front.what, finest, at_spacing(spacing)));
    }
}

/// Where the deposit gets thinner than 6 mm by top, seen from its thickest place, m: several particles thick
/// at every spacing but the coarsest.
double thick_front(const std::vector<DepositRow>& deposit, double toe) {
    constexpr double thickness = 0.006;
    const auto top = &DepositRow::thickness_by_top_m;
    auto row = std::ranges::max_element(deposit, {}, top);
    while (row != deposit.end() && row->thickness_by_top_m >= thickness) ++row;
    if (row == deposit.end() || row == deposit.begin()) return ValidationEntry::none;
    const DepositRow& before = *(row - 1);
    const double part =
        (before.thickness_by_top_m - thickness) / (before.thickness_by_top_m - row->thickness_by_top_m);
    return before.chainage_m + part * (row->chainage_m - before.chainage_m) - toe;
}

void add_thick_fronts(CaseReport& report, const CaseRuns& runs, const Box& box, bool quick) {
    if (!finest_is_there(runs, quick)) return;
    const auto front = [&](const std::string& run) { return thick_front(runs.deposit(run), toe_of(box)); };
    const char* what = "front 6 mm thick by top, m";
    const double finest = front(finest_run);
    report.entries.push_back(held(exact(finest), what, {}, at_spacing(finest_spacing)));
    report.entries.push_back(held(estimate(runs, "head", front), what,
                                  {"own run, dl = 0.6 mm", finest, coarse_band},
                                  at_spacing(spacing_of(quick))));
}

void add_rest(CaseReport& report, const CaseRuns& runs, const Box& box, bool quick) {
    for (const char* id : {"head", "base"}) {
        const bool head = std::string(id) == "head";
        report.entries.push_back(
            held(measured(runs, id, &Measures::time_to_rest_s),
                 fmt::format("all at rest, H_d to the {}, s", head ? "head" : "lower end"),
                 {"the paper, frame (d)", box.last_frame},
                 at_spacing(head ? spacing_of(quick) : base_spacing(quick)),
                 "the frame shows the final deposit; rest here is the engine's own, when the last creeping "
                 "has died"));
    }
}

Figure profile_figure(const CaseRuns& runs, const Box& box, bool quick) {
    Figure figure{"profile", "Final deposit", "x/sqrt(S)", "y/sqrt(S)", {}, true, false};
    const auto add = [&](const std::string& run, double spacing, Curve::Style style) {
        figure.curves.push_back(
            surface_curve(runs, run, toe_of(box), fmt::format("dl = {:g} mm", 1000.0 * spacing), style));
    };
    if (!quick) add(finest_run, finest_spacing, Curve::Style::line);
    add(lattices_of("head").front(), spacing_of(quick), Curve::Style::line);
    add(coarse_lattices_of("head").front(), 2.0 * spacing_of(quick), Curve::Style::line);
    figure.curves.push_back(ground_curve(box.slope_deg, 1.5, box.front_first ? 2.5 : 6.0));
    return figure;
}

void add_remarks(CaseReport& report, const Box& box, bool quick) {
    report.remarks.emplace_back(
        "The measured deposit is a dashed line in a picture of the paper and not available in numbers, so "
        "the "
        "profile is shown and not judged.");
    if (quick) return;
    report.remarks.emplace_back(box.front_first ? "The whole front moves out by 4 to 5 % from 1.5 to 0.6 mm, "
                                                  "more than the error bar that 3 and 1.5 "
                                                  "mm give: a thin, fast front is slow to converge."
                                                : "The thin end of the deposit, a particle or two thick, "
                                                  "goes on growing as the spacing gets finer, "
                                                  "by more than the error bar that 3 and 1.5 mm give; where "
                                                  "the deposit is several particles thick "
                                                  "the spacings agree better.");
}

}  // namespace

double toe_of(const Box& box) {
    return 0.4 / std::tan(radians(box.slope_deg));
}

double spacing_of(bool quick) {
    return quick ? 0.004 : 0.0015;
}

double base_spacing(bool quick) {
    return quick ? 0.004 : 0.003;
}

std::string at_spacing(double spacing) {
    return fmt::format("dl = {:g} mm, {:.0f} particles", 1000.0 * spacing,
                       root_area() * root_area() / (spacing * spacing));
}

bool finest_is_there(const CaseRuns& runs, bool quick) {
    return !quick && is_result(runs.run(finest_run).status);
}

void add_deposit(CaseReport& report, const CaseRuns& runs, const Box& box, bool quick) {
    add_fronts(report, runs, quick);
    add_thick_fronts(report, runs, box, quick);
    add_rest(report, runs, box, quick);
    report.figures.push_back(profile_figure(runs, box, quick));
    add_remarks(report, box, quick);
}

}  // namespace runout::slopes
