#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/input_error.h"
#include "core/output_file.h"
#include "program/command_line.h"
#include "scene/section_cases.h"
#include "store/refused_rows.h"

namespace runout {

/// The row of a section that was refused.
RefusedSection refused_section(const SectionFeature& line, const std::string& reason);

/// What became of the sections of a case. Of many lines each that is refused is told at once and does not
/// stop the others.
class SectionTally {
  public:
    explicit SectionTally(const std::vector<SectionCase>& cases);

    /// Whether one may be refused without the rest.
    [[nodiscard]] bool many() const { return many_; }

    /// Makes something of a section, or notes why not and returns nothing. A single one passes its error on.
    template <class Make>
    auto make(const SectionCase& section, const Make& make) -> std::optional<decltype(make(section.spec))> {
        try {
            if (many_ && section.line->feature.refusal) throw InputError(*section.line->feature.refusal);
            auto made = make(section.spec);
            if (many_) take(*section.line);
            return made;
        } catch (const InputError& error) {
            if (!many_) throw;
            refuse(section, error);
            return std::nullopt;
        }
    }

    /// A section that was taken turns out to be refused.
    void refuse(const SectionCase& section, const InputError& error);

    /// Throws InputError when no section is left: their one reason, where they have one.
    void require_any() const;

    [[nodiscard]] bool any_refused() const { return !sections_.refused.empty(); }
    /// "183 good, 17 refused".
    [[nodiscard]] std::string summary() const;
    [[nodiscard]] const SectionsTaken& sections() const { return sections_; }

  private:
    void take(const SectionFeature& line) { sections_.taken.push_back(line.feature.feature_id); }

    bool many_;
    SectionsTaken sections_;
    std::optional<InputError> first_;
};

/// Says on standard error which section is refused, and why.
void tell_refused(const RefusedSection& section);

/// "183 good, 17 refused".
std::string good_and_refused(std::size_t good, std::size_t refused);

/// Declares `--refused FILE`.
void add_refused_option(Command& command, std::string& path);

/// Writes them as CSV with the columns origin, feature_id, name and reason. Nothing if `path` is empty.
void write_refused(const std::string& path, const std::vector<RefusedSection>& sections,
                   const OutputRules& rules);

}  // namespace runout
