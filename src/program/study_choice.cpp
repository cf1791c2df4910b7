#include "program/study_choice.h"

#include <fmt/format.h>

#include "core/input_error.h"

namespace runout {

StoredStudy chosen_study(const Store& store, const std::string& database, const std::string& name_or_id) {
    const std::vector<StoredStudy> studies = store.studies();
    std::string known;
    for (const StoredStudy& study : studies) {
        if (study.name == name_or_id) return study;
        known += fmt::format("{}{} ({})", known.empty() ? "" : ", ", study.name, study.study_id);
    }
    for (const StoredStudy& study : studies)
        if (std::to_string(study.study_id) == name_or_id) return study;
    throw InputError({.file = database, .line = 0, .key = "--study", .value = name_or_id},
                     "is not in this database", known.empty() ? "it holds no study" : "valid: " + known);
}

}  // namespace runout
