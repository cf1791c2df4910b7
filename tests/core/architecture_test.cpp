// Includes follow the one way through, and each heavy library is included where the design says.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

using Names = std::vector<std::string>;

/// First words of the lines of src/rooms.txt: "core", ..., "engine/threads", ...
Names lines_of_rooms() {
    Names names;
    std::ifstream stream(fs::path(RUNOUT_SOURCE_DIR) / "src" / "rooms.txt");
    for (std::string line; std::getline(stream, line);)
        if (!line.empty() && line.front() != '#') names.push_back(line.substr(0, line.find(' ')));
    return names;
}

/// The rooms in their order. A room may include itself and what stands before it.
const Names& arrow() {
    static const Names rooms = [] {
        Names names = lines_of_rooms();
        std::erase_if(names, [](const std::string& name) { return name.find('/') != std::string::npos; });
        return names;
    }();
    return rooms;
}

/// The inner rooms of the engine, likewise.
const Names& inner_arrow() {
    static const Names rooms = [] {
        Names names = lines_of_rooms();
        std::erase_if(names, [](const std::string& name) { return name.find('/') == std::string::npos; });
        return names;
    }();
    return rooms;
}

/// "engine/pairs" of "engine/pairs/operators.h"; "engine" of what stands at its top.
std::string inner_room_of(const std::string& path) {
    return path.substr(0, path.rfind('/'));
}

/// The engine includes core and itself, and its inner rooms those before them.
bool is_within_engine(const std::string& path, const std::string& header) {
    static const Names plain_data = {"engine/mass.h", "engine/effects.h", "engine/problem.h",
                                     "engine/status.h"};
    if (header.starts_with("core/") || std::ranges::find(plain_data, header) != plain_data.end()) return true;
    if (!header.starts_with("engine/")) return false;
    const auto place = [](const std::string& file) {
        return std::ranges::find(inner_arrow(), inner_room_of(file)) - inner_arrow().begin();
    };
    return place(header) <= place(path);
}

struct Library {
    const char* name;
    std::regex header;
    Names places;  ///< files or rooms where it may be included
};

const std::vector<Library>& heavy_libraries() {
    static const std::vector<Library> libraries = {
        {"CGAL", std::regex("^CGAL/.*"), {"source/polygons.cpp"}},
        {"GDAL", std::regex("^(gdal|ogr|cpl_|gnm|vrtdataset).*"), {"gis"}},
        {"pugixml", std::regex("^pugixml.*"), {"profile/landxml_sections.cpp"}},
        {"CHOLMOD",
         std::regex("^(suitesparse/)?(cholmod|SuiteSparse|umfpack|amd|colamd).*|^Eigen/CholmodSupport"),
         {"engine"}},
        {"SQLite", std::regex("^(SQLiteCpp/.*|sqlite3.*)"), {"store"}},
        {"toml++", std::regex("^toml\\+\\+/.*|^toml\\.hpp"), {"scene/toml_reading.h"}},
        {"Boost", std::regex("^boost/.*"), {"study/distribution.cpp"}},
        {"CLI11", std::regex("^CLI/.*|^CLI11.*"), {"program/command_line.cpp"}},
        {"spdlog", std::regex("^spdlog/.*"), {"program/log.cpp"}},
        {"nlohmann-json", std::regex("^nlohmann/.*"), {"report", "program"}},
    };
    return libraries;
}

Names included_headers(const std::string& text) {
    static const std::regex include(R"re((^|\n)[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"])re");
    Names headers;
    for (auto match = std::sregex_iterator(text.begin(), text.end(), include);
         match != std::sregex_iterator(); ++match)
        headers.push_back((*match)[2]);
    return headers;
}

/// "engine" of "engine/kernel.h"; main.cpp is part of the program. Empty for a system header.
std::string room_of(const std::string& path) {
    if (path == "main.cpp") return "program";
    const std::string first = path.substr(0, path.find('/'));
    const bool known =
        path.find('/') != std::string::npos && std::ranges::find(arrow(), first) != arrow().end();
    return known ? first : "";
}

std::ptrdiff_t position(const std::string& room) {
    return std::ranges::find(arrow(), room) - arrow().begin();
}

bool is_place(const std::string& path, const Names& places) {
    return std::ranges::any_of(
        places, [&](const std::string& place) { return path == place || path.starts_with(place + "/"); });
}

/// What is wrong with the includes of one file, a sentence each.
Names faults(const std::string& path, const std::string& text) {
    Names found;
    for (const std::string& header : included_headers(text)) {
        const std::string room = room_of(header);
        if (!room.empty() && position(room) > position(room_of(path)))
            found.push_back(path + " includes " + header + " against the arrow");
        else if (room_of(path) == "engine" && !room_of(header).empty() && !is_within_engine(path, header))
            found.push_back(path + " includes " + header + " against the arrow within the engine");
        for (const Library& library : heavy_libraries())
            if (std::regex_match(header, library.header) && !is_place(path, library.places))
                found.push_back(path + " includes " + header + ": not the place of " + library.name);
    }
    return found;
}

fs::path source_folder() {
    return fs::path(RUNOUT_SOURCE_DIR) / "src";
}

bool is_code(const fs::path& path) {
    return path.extension() == ".h" || path.extension() == ".cpp" || path.extension() == ".in";
}

Names code_files() {
    Names files;
    for (const auto& entry : fs::recursive_directory_iterator(source_folder()))
        if (entry.is_regular_file() && is_code(entry.path()))
            files.push_back(fs::relative(entry.path(), source_folder()).generic_string());
    std::ranges::sort(files);
    return files;
}

std::string text_of(const std::string& path) {
    std::ifstream stream(source_folder() / path);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Architecture, IncludesFollowTheArrowAndLibrariesStayInTheirPlaces) {
    const Names files = code_files();
    ASSERT_GT(files.size(), 20u);
    for (const std::string& path : files)
        for (const std::string& fault : faults(path, text_of(path))) ADD_FAILURE() << fault;
}

TEST(Architecture, EveryFileBelongsToARoom) {
    for (const std::string& path : code_files()) EXPECT_FALSE(room_of(path).empty()) << path;
}

TEST(Architecture, LibrariesAreUsedWhereTheDesignSaysTheyAre) {
    const Names files = code_files();
    for (const Library& library : heavy_libraries()) {
        const bool used = std::ranges::any_of(files, [&](const std::string& path) {
            return std::ranges::any_of(included_headers(text_of(path)), [&](const std::string& header) {
                return std::regex_match(header, library.header);
            });
        });
        EXPECT_TRUE(used) << library.name << " is not included anywhere: its pattern is out of date";
    }
}

// The checker itself: it must be able to fail.

TEST(ArchitectureChecker, FindsAnIncludeAgainstTheArrow) {
    EXPECT_EQ(faults("engine/kernel.h", "#pragma once\n#include \"store/store.h\"\n").size(), 1u);
    EXPECT_EQ(faults("engine/pairs/operators.h", "#include \"engine/effects/barrier.h\"\n").size(), 1u);
    EXPECT_EQ(faults("engine/watch/rest_watch.h", "#include \"engine/stepper.h\"\n").size(), 1u);
    EXPECT_EQ(faults("engine/effects/release.cpp", "#include \"engine/problem.h\"\n").size(), 0u);
    EXPECT_EQ(faults("core/units.h", "# include \"profile/profile.h\"").size(), 1u);
    EXPECT_EQ(faults("report/table.cpp", "#include \"program/command.h\"\n").size(), 1u);
}

TEST(ArchitectureChecker, AcceptsIncludesAlongTheArrow) {
    EXPECT_TRUE(faults("engine/kernel.h",
                       "#include <vector>\n#include \"core/geometry.h\"\n#include \"engine/soil.h\"\n")
                    .empty());
    EXPECT_TRUE(
        faults("program/command_line.cpp", "#include <CLI/CLI.hpp>\n#include \"report/table.h\"\n").empty());
}

TEST(ArchitectureChecker, FindsLibrariesOutOfPlace) {
    EXPECT_EQ(faults("source/source.cpp", "#include <CGAL/Polygon_2.h>\n").size(), 1u);
    EXPECT_EQ(faults("profile/profile.cpp", "#include <gdal_priv.h>\n").size(), 1u);
    EXPECT_EQ(faults("profile/read_csv.cpp", "#include <ogrsf_frmts.h>\n").size(), 1u);
    EXPECT_EQ(faults("measures/deposit.cpp", "#include <cholmod.h>\n").size(), 1u);
    EXPECT_EQ(faults("report/table.cpp", "#include <SQLiteCpp/SQLiteCpp.h>\n").size(), 1u);
    EXPECT_EQ(faults("scene/scene.cpp", "#include <toml++/toml.h>\n").size(), 1u);
    EXPECT_EQ(faults("program/run_command.cpp", "#include <spdlog/spdlog.h>\n").size(), 1u);
    EXPECT_EQ(faults("main.cpp", "#include <CLI/CLI.hpp>\n").size(), 1u);
}

TEST(ArchitectureChecker, ReadsEveryFormOfInclude) {
    EXPECT_EQ(included_headers("#include <a>\n  #  include \"b/c.h\"\n// #include <d>\n"),
              (Names{"a", "b/c.h"}));
}

}  // namespace
