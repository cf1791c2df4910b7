#pragma once

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

/// All scenarios of a study in an order that depends on nothing but the study. Where the case's section is a
/// layer of many lines, each is a section of its own; what is refused as a section is a scenario that is
/// refused.
class ScenarioList {
  public:
    /// Throws InputError: a case that cannot be read, a key that is not known, a value out of its range, a
    /// correlation that is not positive definite.
    explicit ScenarioList(const Study& study);

    [[nodiscard]] std::size_t size() const { return scenarios_.size(); }
    [[nodiscard]] const Scenario& operator[](std::size_t index) const { return scenarios_[index]; }
    /// The case of one scenario. Throws InputError.
    [[nodiscard]] CaseSpec case_of(std::size_t index) const;

  private:
    CaseSpec base_;
    std::string file_;
    std::vector<Scenario> scenarios_;
};

/// The combinations that the study asks for, sections of a layer apart. Throws InputError.
std::vector<std::vector<Setting>> combinations(const Study& study);

/// How many combinations there are.
double combination_count(const Study& study);

/// {"material.friction_angle_deg": 35.2, "source.type": "B"}: settings as JSON.
std::string settings_json(const std::vector<Setting>& settings);

}  // namespace runout
