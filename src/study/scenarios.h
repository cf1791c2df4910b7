#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "scene/case_spec.h"
#include "scene/section_cases.h"
#include "study/study_file.h"

namespace runout {

/// Key of a case and what it is set to.
using Setting = std::pair<std::string, std::string>;

/// One question of a study.
struct Scenario {
    std::vector<Setting> settings;                 ///< what the study varies
    std::string name;                              ///< of the run
    std::shared_ptr<const SectionFeature> line{};  ///< the section, where the case has a layer of many
};

/// More combinations than this are no study: no machine ends them.
constexpr double most_combinations_of_a_study = 1e6;

/// How many combinations there are, sections of a layer apart; no number is too great for it.
double combination_count(const Study& study);

/// The combinations that a study asks for, each made when it is asked for. One study gives one order.
class Combinations {
  public:
    /// Throws InputError: more than most_combinations_of_a_study, a correlation that is not positive
    /// definite.
    explicit Combinations(const Study& study);

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] std::vector<Setting> operator[](std::size_t index) const;

  private:
    std::vector<Factor> lists_;                  ///< of a full design, the first changing slowest
    std::vector<std::vector<Setting>> samples_;  ///< of a full design, changing fastest; or all that there is
    std::size_t size_ = 0;
};

/// All scenarios of a study in an order that depends on nothing but the study. Where the case's section is a
/// layer of many lines, each is a section of its own; what is refused as a section is a scenario that is
/// refused.
class ScenarioList {
  public:
    /// Throws InputError: more than most_combinations_of_a_study, a case that cannot be read, a key that is
    /// not known, a value out of its range, a correlation that is not positive definite.
    explicit ScenarioList(const Study& study);

    [[nodiscard]] std::size_t size() const { return places_.size(); }
    [[nodiscard]] Scenario operator[](std::size_t index) const;
    /// The case of one scenario. Throws InputError.
    [[nodiscard]] CaseSpec case_of(std::size_t index) const;

  private:
    struct Place {
        std::size_t combination = 0;
        std::string name;
        std::shared_ptr<const SectionFeature> line;
    };
    CaseSpec base_;
    std::map<std::string, std::string> places_of_keys_;  ///< file and line where each is varied
    Combinations combinations_;
    std::vector<Place> places_;
};

/// {"material.friction_angle_deg": 35.2, "source.type": "B"}: settings as JSON.
std::string settings_json(const std::vector<Setting>& settings);

}  // namespace runout
