// What people read: lines that fit on a screen, and links that lead somewhere.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

using Names = std::vector<std::string>;

constexpr std::ptrdiff_t longest_line = 160;  // characters

/// Pages that the program writes: `runout validate --output`, `runout accuracy --page`. Their lines are as
/// long as their tables are wide.
bool is_generated(const std::string& page) {
    return page == "docs/validation.md" || page == "docs/accuracy.md";
}

fs::path top_folder() {
    return RUNOUT_SOURCE_DIR;
}

/// The pages, named from the top folder.
Names pages() {
    Names found = {"README.md", "CHANGELOG.md", "CONTRIBUTING.md", "src/engine/README.md"};
    for (const char* folder : {"docs", "cases"})
        for (const auto& entry : fs::recursive_directory_iterator(top_folder() / folder))
            if (entry.path().extension() == ".md")
                found.push_back(fs::relative(entry.path(), top_folder()).generic_string());
    std::ranges::sort(found);
    return found;
}

std::string text_of(const std::string& page) {
    std::ifstream stream(top_folder() / page);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Of a line in UTF-8.
std::ptrdiff_t characters(const std::string& line) {
    return std::ranges::count_if(line,
                                 [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
}

/// Files that a line links to, without the place in them. A line of code has none.
Names linked_files(const std::string& line) {
    static const std::regex pattern(R"re(\]\(([^)#\s]+))re");
    Names files;
    if (line.starts_with("    ")) return files;
    for (auto match = std::sregex_iterator(line.begin(), line.end(), pattern);
         match != std::sregex_iterator(); ++match) {
        const std::string file = (*match)[1].str();
        if (file.find("://") == std::string::npos) files.push_back(file);
    }
    return files;
}

/// What is wrong with a page, a sentence each.
Names faults(const std::string& page, const std::string& text) {
    Names found;
    const fs::path folder = (top_folder() / page).parent_path();
    std::istringstream stream(text);
    int number = 0;
    for (std::string line; std::getline(stream, line);) {
        const std::string place = page + ":" + std::to_string(++number);
        if (characters(line) > longest_line && !is_generated(page))
            found.push_back(place + " is longer than " + std::to_string(longest_line) + " characters");
        for (const std::string& file : linked_files(line))
            if (!fs::exists(folder / file))
                found.push_back(place + " links to " + file + ", which is not there");
    }
    return found;
}

TEST(Docs, LinesFitAndLinksLeadSomewhere) {
    const Names all = pages();
    ASSERT_GT(all.size(), 20u);
    for (const std::string& page : all) {
        const std::string text = text_of(page);
        EXPECT_FALSE(text.empty()) << page;
        for (const std::string& fault : faults(page, text)) ADD_FAILURE() << fault;
    }
}

// The checker itself: it must be able to fail.

TEST(DocsChecker, FindsALongLineButInGeneratedPages) {
    const std::string fits(160, 'x');
    EXPECT_TRUE(faults("docs/maps.md", fits + "\n").empty());
    EXPECT_EQ(faults("docs/maps.md", fits + "x\n").size(), 1u);
    EXPECT_TRUE(faults("docs/validation.md", fits + "x\n").empty());
    EXPECT_TRUE(faults("docs/maps.md", fits.substr(1) + "\xC3\xB6\n").empty()) << "a letter of two bytes";
}

TEST(DocsChecker, FindsALinkThatLeadsNowhere) {
    EXPECT_EQ(faults("docs/maps.md", "[a](nowhere.md) and [b](maps.md#place)\n").size(), 1u);
    EXPECT_EQ(faults("docs/validation.md", "![picture](nowhere.svg)\n").size(), 1u);
    EXPECT_TRUE(faults("docs/maps.md", "[a](../README.md), [b](https://a.org/b.md), [c](#here)\n").empty());
    EXPECT_TRUE(faults("docs/maps.md", "    [](int value) { return value; }\n").empty());
}

}  // namespace
