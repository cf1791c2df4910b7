// Files that the program writes: whole, known again, and never in the place of another.

#include "core/output_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "said.h"
#include "temporary_folder.h"

namespace runout {
namespace {

namespace fs = std::filesystem;

class OutputFileTest : public testing::Test {
  protected:
    [[nodiscard]] std::string path(const std::string& name) const { return folder_.file(name); }
    [[nodiscard]] std::string text_of(const std::string& name) const {
        std::ifstream stream(path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(path(name), std::ios::binary) << text;
    }
    TemporaryFolder folder_;
};

TEST_F(OutputFileTest, AMarkIsKnownAgainInEveryFormatThatHasAPlaceForOne) {
    for (const auto& [name, text] :
         {std::pair{"a.html", "<!DOCTYPE html>\n<p>x</p>\n"}, std::pair{"a.svg", "<svg/>"},
          std::pair{"a.md", "# A page\n"}, std::pair{"a.json", "{\"a\": [1, 2]}\n"}}) {
        write_output_file(path(name), "-o", text);
        EXPECT_TRUE(is_unedited_output(path(name))) << text_of(name);
        write_output_file(path(name), "-o", text);
        std::string edited = text_of(name);
        for (std::size_t i = 0; i < edited.size(); ++i) {
            std::string one = edited;
            one[i] = one[i] == 'x' ? 'y' : 'x';
            write(name, one);
            const bool in_version = i >= edited.find("Runout ") + 7 && i < edited.find("; sha256");
            EXPECT_EQ(is_unedited_output(path(name)), in_version) << name << " at " << i;
        }
    }
    write_output_file(path("a.csv"), "-o", "a,b\n1,2\n");
    EXPECT_EQ(text_of("a.csv"), "a,b\n1,2\n");
    EXPECT_FALSE(is_unedited_output(path("a.csv")));
}

TEST_F(OutputFileTest, JsonStaysJson) {
    EXPECT_TRUE(with_output_mark("{\"a\": 1}\n", "x").starts_with("{\"a\": 1,\n\"made_by\": \"Runout "));
    EXPECT_TRUE(with_output_mark("{\"a\": 1}\n", "x").ends_with("\"\n}\n"));
    EXPECT_EQ(with_output_mark("{}\n", "x"), "{}\n") << "nothing to lose";
    EXPECT_EQ(with_output_mark("[1]\n", "x"), "[1]\n");
}

TEST_F(OutputFileTest, AMarkTakenFromAnotherFileIsNone) {
    write_output_file(path("a.html"), "-o", "<p>a</p>\n");
    const std::string mark = text_of("a.html").substr(9);
    write("b.html", "<p>b</p>\n" + mark);
    EXPECT_FALSE(is_unedited_output(path("b.html")));
    write("b.html", text_of("a.html") + text_of("a.html"));
    EXPECT_FALSE(is_unedited_output(path("b.html")));
}

TEST_F(OutputFileTest, FilesThatAreTakenAreSparedByAnyName) {
    write("in.db", "data");
    fs::create_hard_link(path("in.db"), path("hard"));
    fs::create_symlink("in.db", path("soft"));
    const OutputRules rules{.taken = database_files(path("in.db")), .overwrite = true};
    for (const char* name : {"in.db", "./in.db", "hard", "soft", "in.db-wal", "./in.db-journal"})
        EXPECT_TRUE(contains(input_error([&] { write_output_file(path(name), "-o", "x", rules); }),
                             "is a file that this command reads or writes itself"))
            << name;
    EXPECT_EQ(text_of("in.db"), "data");
    write_output_file(path("other"), "-o", "x", rules);
    EXPECT_EQ(text_of("other"), "x");
}

TEST_F(OutputFileTest, NothingIsLeftOfAWriteThatFails) {
    fs::create_directory(path("folder"));
    EXPECT_FALSE(input_error([&] { write_output_file(path("folder"), "-o", "x"); }).empty());
    EXPECT_FALSE(input_error([&] { write_output_file(path("no/x"), "-o", "x"); }).empty());
    EXPECT_FALSE(input_error([&] { write_output_file(path(std::string(300, 'x')), "-o", "x"); }).empty());
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 1);
}

TEST_F(OutputFileTest, ASocketIsNoPlace) {
    ASSERT_EQ(mknod(path("socket").c_str(), S_IFSOCK | 0600, 0), 0);
    EXPECT_TRUE(
        contains(input_error([&] { write_output_file(path("socket"), "-o", "x", {.overwrite = true}); }),
                 "is no ordinary file"));
}

}  // namespace
}  // namespace runout
