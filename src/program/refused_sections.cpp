#include "program/refused_sections.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/csv_cell.h"
#include "core/printable.h"
#include "program/log.h"

namespace runout {
namespace {

constexpr const char* option = "--refused";

}  // namespace

RefusedSection refused_section(const SectionFeature& line, const std::string& reason) {
    return {fmt::format("{}, layer {}", line.feature.file, line.feature.layer), line.feature.feature_id,
            line.label, reason, line.feature.drawn};
}

SectionTally::SectionTally(const std::vector<SectionCase>& cases) : many_(cases.size() > 1) {
    if (many_) sections_.origin = refused_section(*cases.front().line, "").origin;
}

void SectionTally::refuse(const SectionCase& section, const InputError& error) {
    std::erase(sections_.taken, section.line->feature.feature_id);
    sections_.refused.push_back(refused_section(*section.line, error.what()));
    if (!first_) first_ = error;
}

void SectionTally::require_any() const {
    if (!many_ || !sections_.taken.empty()) {
        for (const RefusedSection& refused : sections_.refused) tell_refused(refused);
        return;
    }
    // A mistake of the case is no mistake of two hundred lines.
    const std::string& reason = sections_.refused.front().reason;
    const bool one_reason = std::ranges::all_of(
        sections_.refused, [&](const RefusedSection& refused) { return refused.reason == reason; });
    if (one_reason) throw InputError(*first_);
    for (const RefusedSection& refused : sections_.refused) tell_refused(refused);
    throw InputError({sections_.origin, 0, "", ""},
                     fmt::format("has no line that can be taken: {}", summary()), "mend those named above");
}

std::string SectionTally::summary() const {
    return good_and_refused(sections_.taken.size(), sections_.refused.size());
}

void tell_refused(const RefusedSection& section) {
    log_error("feature {} ({}) is refused: {}", section.feature_id, printable(section.name),
              printable(section.reason));
}

std::string good_and_refused(std::size_t good, std::size_t refused) {
    return fmt::format("{} good, {} refused", good, refused);
}

void add_refused_option(Command& command, std::string& path) {
    command
        .add_option(option, &path,
                    "CSV file that takes the lines of a layer that were refused, with the reason")
        .value_name("PATH")
        .group("Output");
}

void write_refused(const std::string& path, const std::vector<RefusedSection>& sections,
                   const OutputRules& rules) {
    if (path.empty()) return;
    std::string text = "origin,feature_id,name,reason\n";
    for (const RefusedSection& section : sections)
        text += fmt::format("{},{},{},{}\n", csv_cell(section.origin), section.feature_id,
                            csv_cell(section.name), csv_cell(section.reason));
    write_output_file(path, option, text, rules);
}

}  // namespace runout
