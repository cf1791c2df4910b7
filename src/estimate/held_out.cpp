#include "estimate/held_out.h"

#include <fmt/format.h>

#include <cmath>

#include "estimate/run_out_chart.h"

namespace runout {
namespace {

constexpr std::size_t turns = 5;

/// Sums of squares stand where the means will.
void hold_out(const ChartPoints& points, std::size_t turn, const std::string& origin, HeldOutCheck& check) {
    ChartPoints kept;
    std::vector<ChartPoint> held_out;
    for (std::size_t i = 0; i < points.points.size(); ++i)
        (i % turns == turn ? held_out : kept.points).push_back(points.points[i]);
    const RunOutChart chart(std::move(kept), origin);
    for (const ChartPoint& run : held_out) {
        ChartQuestion question;
        question.place = run.place;
        try {
            const Estimate estimate = chart.estimate(question);
            const double error = std::abs(estimate.run_out - run.run_out);
            ++check.estimated;
            check.within_68 += error <= estimate.half_width_68 ? 1 : 0;
            check.within_95 += error <= estimate.half_width_95 ? 1 : 0;
            check.error_rms += error * error;
            check.left_out_error_rms += std::pow(chart.left_out_error(), 2);
        } catch (const InputError&) {
            ++check.refused;
        }
    }
}

}  // namespace

HeldOutCheck check_held_out(const ChartPoints& points, const std::string& origin) {
    constexpr std::size_t fewest = RunOutChart::fewest_runs * turns / (turns - 1);
    if (points.points.size() < fewest)
        throw InputError({.file = origin, .line = 0, .key = {}, .value = {}},
                         fmt::format("holds {} settled runs that may be used", points.points.size()),
                         fmt::format("holding out runs needs {}; make them with `runout sweep`", fewest));
    HeldOutCheck check;
    for (std::size_t turn = 0; turn < turns; ++turn) hold_out(points, turn, origin, check);
    if (check.estimated == 0)
        throw InputError({.file = origin, .line = 0, .key = {}, .value = {}},
                         "has no run that lies among the others, so none can be held out",
                         "make more with `runout sweep`");
    for (double* rms : {&check.error_rms, &check.left_out_error_rms})
        *rms = std::sqrt(*rms / static_cast<double>(check.estimated));
    return check;
}

}  // namespace runout
