#include "study/study_identity.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "core/sha256.h"
#include "gis/dataset_files.h"
#include "scene/case_file.h"
#include "scene/input_files.h"

namespace runout {
namespace {

/// What only speeds a look-up, and may be made by whoever looks.
bool is_index(const std::string& file) {
    constexpr std::array endings = {".qix", ".sbn", ".sbx", ".idm", ".ind", ".ovr"};
    return std::ranges::any_of(endings, [&](const char* ending) { return file.ends_with(ending); });
}

/// The files that a value of a key names; other keys name none.
std::vector<std::string> named_files(const std::string& key, const std::string& value) {
    if (key == "section.raster" || key == "section.line") return dataset_files(value);
    if (key.ends_with(".file") || key.ends_with(".record")) return {value};
    return {};
}

std::vector<std::string> files_of(const Study& study) {
    std::vector<std::string> files;
    if (!study.case_file.empty()) files = input_files(read_case(study.case_file));
    for (const Factor& factor : study.factors) {
        const auto* values = std::get_if<std::vector<std::string>>(&factor.values);
        if (values == nullptr) continue;
        for (const std::string& value : *values)
            for (const std::string& file : named_files(factor.key, value)) files.push_back(file);
    }
    return files;
}

}  // namespace

std::vector<std::string> study_files(const Study& study) {
    std::vector<std::string> files = files_of(study);
    for (const std::string& file : {study.file, study.case_file})
        if (!file.empty()) files.push_back(file);
    return files;
}

std::string study_identity(const Study& study) {
    std::string hashes;
    for (const std::string& file : files_of(study)) {
        if (is_index(file)) continue;
        std::error_code ignored;  // a pipe would be empty when the case is read again
        const bool readable = std::filesystem::is_regular_file(file, ignored);
        hashes += (readable ? sha256_of_file(file) : "none") + "\n";
    }
    return fmt::format("{}\n# Files of this study: sha256 {}\n", study.text, sha256_hex(hashes));
}

}  // namespace runout
