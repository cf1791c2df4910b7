#include "report/text/sensitivity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace runout {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t fewest_for_an_index = 50;
constexpr std::size_t fewest_in_a_class = 10;
constexpr std::size_t most_classes = 20;

std::vector<std::size_t> order_of(const std::vector<double>& values) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return values[i]; });
    return order;
}

std::vector<double> mean_ranks(const std::vector<double>& values) {
    const std::vector<std::size_t> order = order_of(values);
    std::vector<double> rank(values.size());
    for (std::size_t k = 0; k < order.size();) {
        std::size_t end = k;
        while (end < order.size() && values[order[end]] == values[order[k]]) ++end;
        for (std::size_t i = k; i < end; ++i) rank[order[i]] = 0.5 * static_cast<double>(k + end - 1);
        k = end;
    }
    return rank;
}

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double first_order_index(const std::vector<double>& input, const std::vector<double>& answer,
                         std::size_t classes) {
    const std::vector<std::size_t> order = order_of(input);
    const double mean = mean_of(answer), n = static_cast<double>(answer.size());
    double between = 0, total = 0;
    for (const double y : answer) total += (y - mean) * (y - mean);
    for (std::size_t c = 0; c < classes; ++c) {
        const std::size_t begin = c * order.size() / classes, end = (c + 1) * order.size() / classes;
        double sum = 0;
        for (std::size_t k = begin; k < end; ++k) sum += answer[order[k]];
        const double count = static_cast<double>(end - begin);
        between += count * (sum / count - mean) * (sum / count - mean);
    }
    if (!(total > 0)) return none;
    // Of an input that does not matter the share expected by chance is (classes - 1) / (n - 1).
    const double chance = (static_cast<double>(classes) - 1) / (n - 1);
    return std::max(0.0, (between / total - chance) / (1 - chance));
}

}  // namespace

double rank_correlation(const std::vector<double>& x, const std::vector<double>& y) {
    if (x.size() < 3) return none;
    const std::vector<double> a = mean_ranks(x), b = mean_ranks(y);
    const double mean = 0.5 * static_cast<double>(x.size() - 1);
    double aa = 0, bb = 0, ab = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        aa += (a[i] - mean) * (a[i] - mean);
        bb += (b[i] - mean) * (b[i] - mean);
        ab += (a[i] - mean) * (b[i] - mean);
    }
    return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : none;
}

std::vector<Sensitivity> sensitivities(const std::vector<VariedInput>& inputs,
                                       const std::vector<double>& answer) {
    std::vector<Sensitivity> all;
    for (const VariedInput& input : inputs) {
        Sensitivity one{input.name, rank_correlation(input.values, answer), none, 0};
        if (answer.size() >= fewest_for_an_index) {
            const std::size_t classes = std::min(most_classes, answer.size() / fewest_in_a_class);
            one.first_order = first_order_index(input.values, answer, classes);
            one.classes = static_cast<int>(classes);
        }
        all.push_back(one);
    }
    return all;
}

}  // namespace runout
