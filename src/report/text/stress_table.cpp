#include "report/text/stress_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace runout {
namespace {

std::string ending_of(const StressOutcome& outcome) {
    if (!outcome.refusal.empty()) return "refused";
    return outcome.result ? std::string(to_string(outcome.result->status)) : "not run";
}

std::string endings(const std::vector<StressOutcome>& outcomes) {
    std::map<std::string, int> counts;
    for (const StressOutcome& outcome : outcomes) ++counts[ending_of(outcome)];
    std::string text = fmt::format("{} scenes\n", outcomes.size());
    for (const auto& [ending, count] : counts) text += fmt::format("  {:<14} {:>6}\n", ending, count);
    return text;
}

struct Worst {
    InvariantRow row;
    int index = 0;
    std::vector<double> values;
};

std::string margins(const std::vector<StressOutcome>& outcomes) {
    std::vector<Worst> worst;
    for (const StressOutcome& outcome : outcomes) {
        if (!outcome.result) continue;
        const auto& rows = outcome.result->invariants;
        worst.resize(rows.size());
        for (std::size_t k = 0; k < rows.size(); ++k) {
            worst[k].values.push_back(rows[k].worst);
            if (worst[k].row.invariant.empty() || rows[k].worst > worst[k].row.worst) {
                worst[k].row = rows[k];
                worst[k].index = outcome.index;
            }
        }
    }
    std::string text =
        fmt::format("{:<16} {:>10} {:>10} {:>10} {:>8}\n", "invariant", "median", "worst", "limit", "scene");
    for (Worst& w : worst) {
        std::ranges::nth_element(w.values, w.values.begin() + static_cast<long>(w.values.size() / 2));
        text += fmt::format("{:<16} {:>10.3g} {:>10.3g} {:>10.3g} {:>8}\n", w.row.invariant,
                            w.values[w.values.size() / 2], w.row.worst, w.row.limit, w.index);
    }
    return text;
}

std::string unsound(const StressOutcome& outcome, std::span<const StressAxis> axes) {
    std::string text = fmt::format("scene {}: {}", outcome.index, ending_of(outcome));
    if (outcome.result) text += fmt::format(": {}", outcome.result->status_detail);
    text += "\n ";
    for (const StressAxis& axis : axes)
        text += fmt::format(" {} {:.5g}", axis.name, outcome.point.*axis.value);
    text += "\n";
    return text;
}

}  // namespace

std::string stress_table(const std::vector<StressOutcome>& outcomes, std::span<const StressAxis> axes) {
    std::string text = fmt::format("{}\n{}", endings(outcomes), margins(outcomes));
    for (const StressOutcome& outcome : outcomes)
        if (!is_sound(outcome)) text += fmt::format("\n{}", unsound(outcome, axes));
    return text;
}

}  // namespace runout
