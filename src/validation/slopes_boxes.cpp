#include "validation/slopes_boxes.h"

#include <fmt/format.h>

#include <cmath>

#include "core/units.h"
#include "validation/slopes_arrival.h"
#include "validation/slopes_shared.h"
#include "validation/suite_cases.h"

namespace runout {
namespace {

using namespace slopes;

constexpr double friction_deg = 38.0;
constexpr double gravity = 9.81;
constexpr double slow_share = 0.05;    // of sqrt(g H_d): speed that counts as rest
constexpr double arrival_band = 0.10;  // README.md

constexpr Box box_45{
    "box-45", "Box of sand on a chute of 45 deg (paper Fig. 10; Bryant et al. 2015)", 45, 0.233, 0.32, 1.0,
    true};
constexpr Box box_70{
    "box-70", "Box of sand on a chute of 70 deg (paper Fig. 11; Bryant et al. 2015)", 70, 0.385, 0.30, 0.65,
    false};

/// Close together around the arrival, then enough for who stops when.
std::string instants() {
    std::string text;
    for (int k = 20; k <= 36; ++k) text += fmt::format("{}{:.2f}", k == 20 ? "[" : ", ", 0.01 * k);
    for (int k = 13; k <= 33; ++k) text += fmt::format(", {:.2f}", 0.03 * k);
    return text + "]";
}

Settings base_datum(const Box& box) {
    // The chutes of the cases end 0.4 m above the bed, too low for a box whose lower end is at 0.385 m.
    return {{"section.file", chute_file(box.slope_deg)},
            {"source.drop_height_datum", "base"},
            {"run.snapshot_times_s", instants()}};
}

std::vector<PlannedRun> plan_box(const Box& box, bool quick) {
    const std::string file = fmt::format("{}/case.toml", box.name);
    const Settings snapshots{{"run.snapshot_times_s", instants()}};
    std::vector<PlannedRun> plan;
    plan_ensemble(plan, "head", file, snapshots, "run.particle_spacing_m", spacing_of(quick));
    plan_ensemble(plan, "base", file, base_datum(box), "run.particle_spacing_m", base_spacing(quick));
    if (!quick) {
        PlannedRun finest{finest_run, file, snapshots};
        finest.set.emplace_back("run.particle_spacing_m", text_of(finest_spacing));
        plan.push_back(finest);
    }
    return plan;
}

// --- arrival ---------------------------------------------------------------------------------------------

double arrival_of(const CaseRuns& runs, const std::string& run) {
    return first_on_bed(runs.snapshots(run), runs.run(run).work.particle_spacing_m);
}

/// Time in which a rigid block slides so far that its lower end is at the toe.
double block_time(const Box& box, DropDatum datum) {
    const double slope = radians(box.slope_deg);
    const double way = box.drop_height / std::sin(slope) - (datum == DropDatum::head ? box_length : 0.0);
    const double acceleration =
        gravity * (std::sin(slope) - std::sin(radians(friction_deg)) * std::cos(slope));
    return std::sqrt(2.0 * way / acceleration);
}

void add_arrivals(CaseReport& report, const CaseRuns& runs, const Box& box, const std::string& id,
                  DropDatum datum, const std::string& at) {
    const bool base = datum == DropDatum::base;
    const std::string where = fmt::format(", H_d to the {}, s", base ? "lower end" : "head");
    const Estimate arrival =
        estimate(runs, id, [&](const std::string& run) { return arrival_of(runs, run); });
    const Estimate mass =
        estimate(runs, id, [&](const std::string& run) { return passes_toe(runs.series(run)); });
    // The datum is not known beforehand: the one that fails is shown, not judged.
    const ReferenceValue frame{"the paper, frame (a)", box.arrival,
                               base ? arrival_band : ValidationEntry::none};
    report.entries.push_back(held(arrival, "first soil on the bed" + where, frame, at,
                                  base ? "the datum that reproduces the paper"
                                       : "not judged: the paper's time belongs to the other datum (README)"));
    report.entries.push_back(
        held(mass, "99.5 % mass point passes the toe" + where, {"the paper, frame (a)", box.arrival}, at));
    const double bound = block_time(box, datum);
    report.entries.push_back(
        limited({arrival.mean / bound, arrival.scatter / bound, arrival.error / bound},
                fmt::format("arrival over that of a rigid block ({:.3f} s), H_d to the {}", bound,
                            base ? "lower end" : "head"),
                {"exact bound: soil spreads", ValidationEntry::none, 1.0}, at));
}

void add_rear(CaseReport& report, const CaseRuns& runs, bool quick) {
    const auto share = [&](const std::string& run) {
        return rear_speed_share(runs.snapshots(run), arrival_of(runs, run));
    };
    const auto add = [&](const Estimate& rear, const std::string& datum, double spacing) {
        report.entries.push_back(
            held(rear, "speed of the rear tenth over the front tenth at arrival, H_d to the " + datum,
                 {"the paper, text"}, at_spacing(spacing), "the paper: the rear end is still stationary"));
    };
    add(estimate(runs, "base", share), "lower end", base_spacing(quick));
    if (finest_is_there(runs, quick)) add(exact(share(finest_run)), "head", finest_spacing);
}

// --- sequence --------------------------------------------------------------------------------------------

Sequence sequence_in(const CaseRuns& runs, const Box& box, const std::string& run) {
    return sequence_of(runs.series(run), runs.snapshots(run), box_length,
                       slow_share * std::sqrt(gravity * box.drop_height));
}

/// `of(quantity)` makes the number: over an ensemble, or of one run.
template <class Of>
void add_sequence(CaseReport& report, const Box& box, const std::string& at, const Of& of) {
    const ReferenceValue order{"the paper, text", ValidationEntry::none, 0.0};
    const auto between = [&](const std::string& earlier, const std::string& later, double Sequence::*a,
                             double Sequence::*b) {
        report.entries.push_back(limited(of([=](const Sequence& s) { return s.*a - s.*b; }),
                                         fmt::format("rest of the {} less rest of the {}, s", earlier, later),
                                         order, at));
    };
    const std::string toe = "soil within a box length of the toe", slope = "soil on the chute";
    if (box.front_first) {
        between("front", toe, &Sequence::front, &Sequence::toe);
        between(toe, slope, &Sequence::toe, &Sequence::slope);
    } else {
        between(slope, toe, &Sequence::slope, &Sequence::toe);
        between(toe, "front", &Sequence::toe, &Sequence::front);
    }
    report.entries.push_back(
        held(of([](const Sequence& s) { return s.front; }), "rest of the front, s", {}, at));
    report.entries.push_back(
        held(of([](const Sequence& s) { return s.moving_behind; }),
             "share of the soil on the chute and moving when the front stops", {"the paper, text"}, at,
             box.front_first ? "there is still mass left on the slope" : "the front stops last"));
}

void add_sequences(CaseReport& report, const CaseRuns& runs, const Box& box, bool quick) {
    add_sequence(report, box, at_spacing(spacing_of(quick)), [&](const auto& quantity) {
        return estimate(runs, "head",
                        [&](const std::string& run) { return quantity(sequence_in(runs, box, run)); });
    });
    if (!finest_is_there(runs, quick)) return;
    add_sequence(report, box, at_spacing(finest_spacing),
                 [&](const auto& quantity) { return exact(quantity(sequence_in(runs, box, finest_run))); });
}

CaseReport evaluate_box(const Box& box, const CaseRuns& runs, bool quick) {
    CaseReport report{box.name, box.title, {}, {}, {}};
    add_arrivals(report, runs, box, "base", DropDatum::base, at_spacing(base_spacing(quick)));
    add_arrivals(report, runs, box, "head", DropDatum::head, at_spacing(spacing_of(quick)));
    if (finest_is_there(runs, quick))
        report.entries.push_back(held(exact(arrival_of(runs, finest_run)),
                                      "first soil on the bed, H_d to the head, s",
                                      {"the paper, frame (a)", box.arrival}, at_spacing(finest_spacing)));
    if (box.front_first) add_rear(report, runs, quick);
    add_sequences(report, runs, box, quick);
    add_deposit(report, runs, box, quick);
    return report;
}

}  // namespace

ValidationCase box_45_case() {
    return {box_45.name, [](bool quick) { return plan_box(box_45, quick); },
            [](const CaseRuns& runs, const std::string&, bool quick) {
                return evaluate_box(box_45, runs, quick);
            }};
}

ValidationCase box_70_case() {
    return {box_70.name, [](bool quick) { return plan_box(box_70, quick); },
            [](const CaseRuns& runs, const std::string&, bool quick) {
                return evaluate_box(box_70, runs, quick);
            }};
}

}  // namespace runout
