// Every input that a fuzzer was given to start from or has found goes through the readers again.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "fuzz/targets.h"

namespace runout {
namespace {

namespace fs = std::filesystem;

int replay(const char* name, void (*target)(std::span<const std::uint8_t>)) {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(fs::path(RUNOUT_SOURCE_DIR) / "tests/corpus" / name)) {
        std::ifstream file(entry.path(), std::ios::binary);
        const std::vector<char> text{std::istreambuf_iterator<char>(file), {}};
        const std::vector<std::uint8_t> bytes(text.begin(), text.end());
        SCOPED_TRACE(entry.path().filename());
        target(bytes);
        ++count;
    }
    return count;
}

TEST(Corpus, OfTheCsvReader) {
    EXPECT_GT(replay("csv_reader", fuzz::read_section), 10);
}
TEST(Corpus, OfSectionsInAnyFormat) {
    EXPECT_GT(replay("section_file", fuzz::read_any_section), 10);
}
TEST(Corpus, OfTheCaseReader) {
    EXPECT_GT(replay("case_reader", fuzz::read_case_file), 10);
}
TEST(Corpus, OfTheSourceDerivation) {
    EXPECT_GT(replay("source_derivation", fuzz::derive_any_source), 10);
}
TEST(Corpus, OfTheStudyReader) {
    EXPECT_GT(replay("study_reader", fuzz::read_study_file), 10);
}
TEST(Corpus, OfTheDatabaseReader) {
    EXPECT_GT(replay("database_reader", fuzz::read_damaged_database), 10);
}
TEST(Corpus, OfTheMapWriter) {
    EXPECT_GT(replay("map_writer", fuzz::write_any_map), 10);
}

}  // namespace
}  // namespace runout
