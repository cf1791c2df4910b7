#include "report/text/coverage_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace runout {
namespace {

/// Of the runs for one target. Shares are of the run-out, or of sqrt(S) where that is more.
struct Coverage {
    int inside = 0;
    std::vector<double> bars, errors, cpu_s;
    double signed_sum = 0;
};

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

void add(Coverage& coverage, const ChoiceCheck& check, double scale) {
    const Appraisal& appraisal = check.run.appraisal;
    coverage.inside += check.inside ? 1 : 0;
    coverage.bars.push_back(appraisal.run_out_error_m / scale);
    coverage.errors.push_back(std::abs(check.off_finest_m) / scale);
    coverage.signed_sum += check.off_finest_m / scale;
    coverage.cpu_s.push_back(check.run.work.cpu_s + appraisal.choosing_cpu_s);
}

std::string line(const std::string& target, const Coverage& coverage) {
    const double runs = static_cast<double>(coverage.bars.size());
    return fmt::format("{:>6}  {:>5.0f}  {:>6.1f} %  {:>6.2f} %  {:>7.2f} %  {:>+7.2f} %  {:>7.2g} s\n",
                       target, runs, 100 * coverage.inside / runs, 100 * median(coverage.bars),
                       100 * median(coverage.errors), 100 * coverage.signed_sum / runs,
                       median(coverage.cpu_s));
}

}  // namespace

std::string coverage_table(std::span<const AccuracyStudy> studies) {
    std::vector<std::pair<std::string, Coverage>> by_target;  // in the order in which they were asked
    const auto of_target = [&](const std::string& target) -> Coverage& {
        const auto known = std::ranges::find(by_target, target, &std::pair<std::string, Coverage>::first);
        return known != by_target.end() ? known->second : by_target.emplace_back(target, Coverage{}).second;
    };
    for (const AccuracyStudy& study : studies) {
        const RungSummary& finest = study.ladder.rungs.back();
        if (finest.results < 2 || finest.failed > 0 || !(finest.values[0].mean > 0)) continue;
        const double scale = reference_of(study.ladder).scale_m;
        for (const ChoiceCheck& check : study.choices)
            if (check.run.appraisal.error_origin == "pilot" && is_result(check.run.status))
                add(of_target(check.target), check, scale);
    }
    std::string text = "target   runs    inside  bar (med)  error (med)   signed    CPU (med)\n";
    for (const auto& [target, coverage] : by_target) text += line(target, coverage);
    return text;
}

}  // namespace runout
