#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "said.h"
#include "scene/case_file.h"
#include "scene/parameters.h"
#include "scene/scene.h"
#include "temporary_folder.h"

namespace runout {

namespace fs = std::filesystem;

/// A folder of its own for each test, with a section in it.
class SceneTest : public testing::Test {
  protected:
    SceneTest() { write("section.csv", "chainage_m,elevation_m\n0,0.4\n0.3,0.4\n0.45,0\n2,0\n"); }

    [[nodiscard]] std::string path(const std::string& name) const { return folder_.file(name); }

    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(path(name), std::ios::binary) << text;
        return path(name);
    }

    /// A sound case: a triangle on the face, in four lines of source and one of material, and then `more`.
    [[nodiscard]] CaseSpec sound_case(const std::string& more = "") const {
        return read_case(write("case.toml",
                               "[section]\n"               // line 1
                               "file = \"section.csv\"\n"  // 2
                               "[source]\n"                // 3
                               "type = \"B\"\n"            // 4
                               "base_angle_deg = 35\n"     // 5
                               "scarp_angle_deg = 80\n"    // 6
                               "height_m = 0.2\n"          // 7
                               "[material]\n"              // 8
                               "friction_angle_deg = 38\n" +
                                   more));
    }

    /// What is said of a case file with this text, read and made into a scene.
    [[nodiscard]] std::string complaint(const std::string& text) const {
        const std::string file = write("bad.toml", text);
        return input_error([&] { make_scene(read_case(file)); });
    }

    TemporaryFolder folder_;
};

inline void expect_complaint(const std::string& sentence, const std::vector<std::string>& parts) {
    EXPECT_FALSE(sentence.empty()) << "nothing was said";
    for (const std::string& part : parts)
        EXPECT_TRUE(contains(sentence, part)) << part << " is not in: " << sentence;
}

/// A text inside the parameter's range that differs from the default.
inline std::string sample_text(const Parameter& parameter) {
    switch (parameter.kind) {
        case ValueKind::choice:
            return std::string(parameter.choices.back());
        case ValueKind::text:
            return "a-name";
        case ValueKind::place:
            return "[1.0, 2.0]";
        case ValueKind::points:
            return "[[1.0, 2.0], [3.0, 4.0], [1, 3]]";
        case ValueKind::numbers:
            return "[0.25, 0.5]";
        case ValueKind::rows:
            return parameter.choices.size() == 2 ? "[[1, 0.2], [2, 0.3]]" : "[[1, 2, 10]]";
        case ValueKind::integer:
            return "7";
        case ValueKind::number:
            break;
    }
    for (const char* candidate : {"17.5", "1.75", "0.25", "0.025", "1750", "75"}) {
        const double value = std::stod(candidate);
        if (parameter.range.contains(value)) return candidate;
    }
    return "?";
}

}  // namespace runout
