// Names that would obey no rule: shown on one line, as a file, as a cell of a spreadsheet.

#include "core/printable.h"

#include <gtest/gtest.h>

#include <random>

#include "core/csv_cell.h"

namespace runout {
namespace {

TEST(Printable, LeavesNamesOfAllScriptsAsTheyAre) {
    for (const char* name :
         {"", "cut-60", "Hang Böschung 3", "斜坡 11SW-D/C1", "שפוע", "склон", "a\xf0\x9f\x9a\xa7z"})
        EXPECT_EQ(printable(name), name);
}

TEST(Printable, ShowsWhatATerminalWouldObey) {
    EXPECT_EQ(printable("a\nb\tc\rd"), "a\\x0ab\\x09c\\x0dd");
    EXPECT_EQ(printable(std::string("a\0b", 3)), "a\\x00b");
    EXPECT_EQ(printable("\x1b[2J\x7f"), "\\x1b[2J\\x7f");
    EXPECT_EQ(printable("\xc2\x9b"
                        "31m"),
              "\\xc2\\x9b31m")
        << "C1: the same as ESC [";
    EXPECT_EQ(printable("\xe2\x80\xae"
                        "gpj"),
              "\\xe2\\x80\\xaegpj")
        << "right-to-left override";
    EXPECT_EQ(printable("\xe2\x81\xa6\xe2\x80\xa8"), "\\xe2\\x81\\xa6\\xe2\\x80\\xa8");
    EXPECT_EQ(printable("\xf3\xa0\x81\x81"), "\\xf3\\xa0\\x81\\x81") << "a tag, which no one sees";
}

TEST(Printable, ShowsBytesThatAreNoText) {
    EXPECT_EQ(printable("\x9b"
                        "31m"),
              "\\x9b31m");
    EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf") << "overlong";
    EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "surrogate";
    EXPECT_EQ(printable("a\xe2\x82"), "a\\xe2\\x82") << "cut off";
}

TEST(Printable, KeepsLinesWhereTheyAreWanted) {
    EXPECT_EQ(printable_lines("a\nb\x1b\n"), "a\nb\\x1b\n");
    EXPECT_EQ(printable_json("{\n\"a\": \"\x7f\xc2\x85\xff\"}"), "{\n\"a\": \"\\u007f\\u0085\\ufffd\"}");
    EXPECT_EQ(printable_json("\"\xf3\xa0\x81\x81\""), "\"\\udb40\\udc41\"");
}

TEST(Printable, OfAnyBytesNothingIsLeftThatMoves) {
    std::mt19937 random(1);
    std::uniform_int_distribution<int> byte(0, 255);
    for (int k = 0; k < 2000; ++k) {
        std::string bytes(16, ' ');
        for (char& c : bytes) c = static_cast<char>(byte(random));
        const std::string shown = printable(bytes);
        EXPECT_EQ(printable(shown), shown);
        for (const char c : shown) EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 && c != 0x7F);
        const std::string part = file_name_part(bytes);
        EXPECT_FALSE(part.empty());
        EXPECT_EQ(part.find('/'), std::string::npos);
        EXPECT_NE(part.front(), '.');
        EXPECT_LE(part.size(), 100u);
    }
}

TEST(FileNames, StayInTheirFolder) {
    EXPECT_EQ(file_name_part("11SW-D/C1"), "11SW-D_C1");
    EXPECT_EQ(file_name_part("../../X"), "_._.._X");
    EXPECT_EQ(file_name_part(".."), "__");
    EXPECT_EQ(file_name_part("."), "_");
    EXPECT_EQ(file_name_part(""), "_");
    EXPECT_EQ(file_name_part("-rf"), "_rf");
    EXPECT_EQ(file_name_part(std::string("a\0b", 3)), "a_b");
    EXPECT_EQ(file_name_part("C:\\x*?"), "C__x__");
    EXPECT_EQ(file_name_part("斜坡"), "斜坡");
}

TEST(FileNames, LongOnesAreCutBetweenLetters) {
    std::string name;
    for (int i = 0; i < 200; ++i) name += "坡";
    const std::string part = file_name_part(name);
    EXPECT_LE(part.size(), 100u);
    EXPECT_EQ(part.size() % 3, 0u);
    EXPECT_EQ(printable(part), part);
}

TEST(FileNames, OfOneFolderAreDistinct) {
    EXPECT_EQ(distinct_file_names({"a/b", "a:b", "A_B", "c", "c", "c-2"}),
              (std::vector<std::string>{"a_b", "a_b-2", "A_B-3", "c", "c-2", "c-2-2"}));
}

TEST(CsvCells, AreNeverFormulas) {
    EXPECT_EQ(csv_cell("=HYPERLINK(\"http://x\")"), "\"'=HYPERLINK(\"\"http://x\"\")\"");
    EXPECT_EQ(csv_cell("@SUM(A1)"), "\"'@SUM(A1)\"");
    EXPECT_EQ(csv_cell("+cmd|' /C calc'!A0"), "\"'+cmd|' /C calc'!A0\"");
    EXPECT_EQ(csv_cell("-cut 60"), "\"'-cut 60\"");
    EXPECT_EQ(csv_cell("  =1+1"), "\"'  =1+1\"");
    EXPECT_EQ(csv_cell("\t=1"), "\\x09=1") << "the tab is shown, and the cell begins with a backslash";
    EXPECT_EQ(csv_cell("\xef\xbc\x9d"
                       "1"),
              "\"'\xef\xbc\x9d"
              "1\"")
        << "a wide equals sign";
}

TEST(CsvCells, LeaveNumbersAndWordsAlone) {
    for (const char* text : {"", "cut-60", "-12.5", "+3", "-1e-3", "a=b", "5 %"})
        EXPECT_EQ(csv_cell(text), text);
    EXPECT_EQ(csv_cell("a,b"), "\"a,b\"");
    EXPECT_EQ(csv_cell("a\nb"), "a\\x0ab") << "a name is one line";
    EXPECT_EQ(csv_cell("-inf"), "\"'-inf\"");
}

}  // namespace
}  // namespace runout
