#include "study/scenarios.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>

#include "scene/case_file.h"
#include "scene/scene.h"
#include "study/distribution.h"

namespace runout {
namespace {

using Settings = std::vector<Setting>;

constexpr double median = 0.5;
// What a distribution stands for when it is varied alone.
constexpr double one_at_a_time_probabilities[] = {0.05, 0.5, 0.95};

std::string number_text(double value) {
    return fmt::format("{:.9g}", value);
}

const std::vector<std::string>& list_of(const Factor& factor) {
    return std::get<std::vector<std::string>>(factor.values);
}

std::string at_probability(const Factor& factor, double probability) {
    return number_text(quantile(std::get<Distribution>(factor.values), probability));
}

/// Target correlations of the sampled factors, by their order among those.
Eigen::MatrixXd correlation_matrix(const Study& study) {
    std::vector<Eigen::Index> column(study.factors.size(), 0);
    Eigen::Index count = 0;
    for (std::size_t i = 0; i < study.factors.size(); ++i)
        if (study.factors[i].is_sampled()) column[i] = count++;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(count, count);
    for (const Correlation& c : study.correlations)
        matrix(column[c.first], column[c.second]) = matrix(column[c.second], column[c.first]) = c.rank;
    return matrix;
}

/// One row of settings for each sample; a single empty one when nothing is sampled.
std::vector<Settings> samples_of(const Study& study) {
    if (study.samples == 0) return {Settings{}};
    Eigen::MatrixXd table;
    try {
        table = latin_hypercube(study.samples, correlation_matrix(study), study.seed);
    } catch (const std::invalid_argument&) {
        throw InputError({.file = study.file, .line = 0, .key = "correlation", .value = {}},
                         "is not positive definite", "give correlations that can hold together");
    }
    std::vector<Settings> rows(static_cast<std::size_t>(study.samples));
    Eigen::Index column = 0;
    for (const Factor& factor : study.factors) {
        if (!factor.is_sampled()) continue;
        for (std::size_t i = 0; i < rows.size(); ++i)
            rows[i].emplace_back(factor.key,
                                 at_probability(factor, table(static_cast<Eigen::Index>(i), column)));
        ++column;
    }
    return rows;
}

std::vector<std::string> alone(const Factor& factor) {
    if (!factor.is_sampled()) return list_of(factor);
    std::vector<std::string> values;
    for (const double probability : one_at_a_time_probabilities)
        values.push_back(at_probability(factor, probability));
    return values;
}

std::vector<Settings> one_at_a_time_design(const Study& study) {
    Settings middle;
    for (const Factor& factor : study.factors)
        middle.emplace_back(factor.key,
                            factor.is_sampled() ? at_probability(factor, median) : list_of(factor).front());
    std::vector<Settings> all = {middle};
    for (std::size_t i = 0; i < study.factors.size(); ++i)
        for (const std::string& value : alone(study.factors[i])) {
            if (value == middle[i].second) continue;
            all.push_back(middle);
            all.back()[i].second = value;
        }
    return all;
}

void check_count(const Study& study, double count) {
    if (count > most_combinations_of_a_study)
        throw InputError(
            {.file = study.file, .line = 0, .key = "vary", .value = {}},
            fmt::format("asks for {:.9g} combinations", count),
            fmt::format("give at most {:.0f}: fewer or shorter lists, or samples of distributions",
                        most_combinations_of_a_study));
}

CaseSpec with_settings(const CaseSpec& base, const Settings& settings,
                       const std::map<std::string, std::string>& places) {
    CaseSpec spec = base;
    for (const auto& [key, value] : settings) override_value(spec, key, value, places.at(key));
    return spec;
}

/// "study.toml, line 5", for each key that is varied.
std::map<std::string, std::string> places_of(const Study& study) {
    std::map<std::string, std::string> places;
    for (const Factor& factor : study.factors)
        places[factor.key] = fmt::format("{}, line {}", study.file, factor.place.line);
    return places;
}

CaseSpec base_of(const Study& study) {
    if (!study.case_file.empty()) return read_case(study.case_file);
    CaseSpec spec;
    spec.file = study.file;
    spec.name = study.name;
    return spec;
}

/// A number as a number, anything else as text.
std::string json_value(const std::string& text) {
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error == std::errc{} && end == text.data() + text.size() && std::isfinite(number))
        return number_text(number);
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return quoted + '"';
}

}  // namespace

double combination_count(const Study& study) {
    double product = std::max(1, study.samples), sum = 1;
    for (const Factor& factor : study.factors) {
        const double values = factor.is_sampled() ? 1.0 : static_cast<double>(list_of(factor).size());
        product *= values;
        sum += factor.is_sampled() ? 2.0 : values - 1;
    }
    return study.design == StudyDesign::full ? product : sum;
}

Combinations::Combinations(const Study& study) {
    check_count(study, combination_count(study));
    const bool full = study.design == StudyDesign::full;
    samples_ = full ? samples_of(study) : one_at_a_time_design(study);
    size_ = samples_.size();
    if (!full) return;
    for (const Factor& factor : study.factors) {
        if (factor.is_sampled()) continue;
        lists_.push_back(factor);
        size_ *= list_of(factor).size();
    }
}

std::vector<Setting> Combinations::operator[](std::size_t index) const {
    const Settings& sample = samples_[index % samples_.size()];
    std::size_t left = index / samples_.size();
    Settings settings(lists_.size());
    for (std::size_t i = lists_.size(); i-- > 0;) {
        const std::vector<std::string>& values = list_of(lists_[i]);
        settings[i] = {lists_[i].key, values[left % values.size()]};
        left /= values.size();
    }
    settings.insert(settings.end(), sample.begin(), sample.end());
    return settings;
}

ScenarioList::ScenarioList(const Study& study)
    : base_(base_of(study)), places_of_keys_(places_of(study)), combinations_(study) {
    for (std::size_t k = 0; k < combinations_.size(); ++k) {
        std::vector<SectionCase> sections =
            section_cases(with_settings(base_, combinations_[k], places_of_keys_));
        const bool many = sections.size() > 1;
        check_count(study, static_cast<double>(places_.size() + sections.size()));
        for (SectionCase& section : sections) {
            std::shared_ptr<const SectionFeature> line;
            if (many) line = std::make_shared<const SectionFeature>(std::move(*section.line));
            places_.push_back({k, section.spec.name, std::move(line)});
        }
    }
}

Scenario ScenarioList::operator[](std::size_t index) const {
    const Place& place = places_.at(index);
    return {combinations_[place.combination], place.name, place.line};
}

CaseSpec ScenarioList::case_of(std::size_t index) const {
    const Scenario scenario = (*this)[index];
    CaseSpec spec = with_settings(base_, scenario.settings, places_of_keys_);
    spec.name = scenario.name;
    if (!scenario.line) return spec;
    if (scenario.line->feature.refusal) throw InputError(*scenario.line->feature.refusal);
    spec.section.map.line.feature_id = scenario.line->feature.feature_id;
    return spec;
}

std::string settings_json(const std::vector<Setting>& settings) {
    std::string text = "{";
    for (const auto& [key, value] : settings)
        text += fmt::format("{}\"{}\": {}", text.size() > 1 ? ", " : "", key, json_value(value));
    return text + "}";
}

}  // namespace runout
