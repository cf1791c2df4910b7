#pragma once

#include <string>
#include <vector>

namespace runout {

/// One varied number over the samples of a study.
struct VariedInput {
    std::string name;
    std::vector<double> values;
};

/// How much an input matters for an answer.
struct Sensitivity {
    std::string name;
    double rank_correlation = 0;  ///< Spearman; NaN when either does not vary
    /// First-order Sobol index from the samples as they are: the variance of the means of the answer over
    /// equally filled classes of the input, less what chance gives, over the variance of the answer (Plischke
    /// 2010). NaN below 50 samples.
    double first_order = 0;
    int classes = 0;
};

std::vector<Sensitivity> sensitivities(const std::vector<VariedInput>& inputs,
                                       const std::vector<double>& answer);

/// Spearman's rank correlation; ties have their mean rank.
double rank_correlation(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace runout
