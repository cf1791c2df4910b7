#include "study/study_identity.h"

#include <fmt/format.h>

#include <filesystem>

#include "core/sha256.h"
#include "scene/case_file.h"
#include "scene/input_files.h"

namespace runout {
namespace {

/// Values of keys that name files; other values name none, and are no files.
std::vector<std::string> files_of(const Study& study) {
    std::vector<std::string> files;
    if (!study.case_file.empty()) files = input_files(read_case(study.case_file));
    for (const Factor& factor : study.factors)
        if (const auto* values = std::get_if<std::vector<std::string>>(&factor.values))
            for (const std::string& value : *values)
                if (factor.key.ends_with(".file") || factor.key.ends_with(".raster") ||
                    factor.key.ends_with(".line") || factor.key.ends_with(".record"))
                    files.push_back(value);
    return files;
}

}  // namespace

std::string study_identity(const Study& study) {
    std::string hashes;
    for (const std::string& file : files_of(study)) {
        std::error_code ignored;  // a pipe would be empty when the case is read again
        const bool readable = std::filesystem::is_regular_file(file, ignored);
        hashes += (readable ? sha256_of_file(file) : "none") + "\n";
    }
    return fmt::format("{}\n# Files of this study: sha256 {}\n", study.text, sha256_hex(hashes));
}

}  // namespace runout
