// Random sections, written in every dialect: what is read is the section, or a refusal where the text leaves
// a choice. Never another section.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>
#include <vector>

#include "profile/read_section_table.h"
#include "said.h"

using namespace runout;

namespace {

using Random = std::mt19937;

double uniform(Random& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

int up_to(Random& random, int most) {
    return std::uniform_int_distribution<int>(0, most)(random);
}

struct Header {
    const char* chainage;
    const char* elevation;
    double chainage_unit;
    double elevation_unit;
};

constexpr double foot = 0.3048;
constexpr double us_foot = 1200.0 / 3937.0;
constexpr std::array<Header, 7> headers = {{{"", "", 1, 1},
                                            {"chainage_m", "elevation_m", 1, 1},
                                            {"Distance (ft)", "Elev (ft)", foot, foot},
                                            {"Abstand", "Höhe", 1, 1},
                                            {"X", "Z", 1, 1},
                                            {"Station_m", "Z_usft", 1, us_foot},
                                            {"STATION [m]", "RL [m]", 1, 1}}};
constexpr std::array<const char*, 5> separators = {",", ";", "|", "\t", " "};
constexpr std::array<const char*, 3> line_ends = {"\n", "\r\n", "\r"};

enum class Encoding { utf8, utf8_marked, utf16_le, utf16_be, utf16_le_marked, utf16_be_marked, windows_1252 };
enum class Thousands { none, apostrophe, hard_blank, other_mark };
enum class Extra { none, id_before, name_behind, remarks };

struct Dialect {
    std::size_t separator = 0;
    bool comma = false;
    std::size_t header = 0;
    std::size_t line_end = 0;
    Encoding encoding = Encoding::utf8;
    Extra extra = Extra::none;
    bool stations = false;
    // The others are drawn for each.
    Thousands thousands = Thousands::none;
    int decimals = 3;
    bool falling = false;
    bool repeated_end = false;
    bool trailing_separator = false;

    [[nodiscard]] std::string name() const {
        return fmt::format(
            "separator '{}', {}, header '{}', encoding {}, extra {}, stations {}, thousands {}, decimals {}",
            separators[separator], comma ? "comma" : "point", headers[header].chainage,
            static_cast<int>(encoding), static_cast<int>(extra), stations, static_cast<int>(thousands),
            decimals);
    }
};

/// "1234.50" with the marks of the dialect.
std::string written(double value, const Dialect& dialect, bool grouped) {
    std::string text = fmt::format("{:.{}f}", value, dialect.decimals);
    const std::size_t point = std::min(text.find('.'), text.size());
    std::string whole = text.substr(0, point);
    std::string decimals = text.substr(point);
    if (dialect.comma && !decimals.empty()) decimals.front() = ',';
    constexpr std::array<const char*, 3> marks = {"", "'", "\xC2\xA0"};
    const std::string mark = dialect.thousands == Thousands::other_mark
                                 ? (dialect.comma ? "." : ",")
                                 : marks[static_cast<std::size_t>(dialect.thousands)];
    const std::size_t sign = whole.starts_with('-') ? 1 : 0;
    if (grouped && whole.size() > sign + 3) whole.insert(whole.size() - 3, mark);
    return whole + decimals;
}

/// "12+345.6"
std::string station(double value, const Dialect& dialect) {
    const std::string text = written(value, dialect, false);
    const std::size_t whole = std::min(text.find_first_of(".,"), text.size());
    const std::string padded = std::string(whole < 4 ? 4 - whole : 0, '0') + text;
    const std::size_t end = std::min(padded.find_first_of(".,"), padded.size());
    return padded.substr(0, end - 3) + "+" + padded.substr(end - 3);
}

/// A cell that holds the separator is quoted, as every program does.
std::string cell(const std::string& text, const Dialect& dialect) {
    return text.find(separators[dialect.separator]) == std::string::npos ? text : '"' + text + '"';
}

struct Written {
    std::string text;
    std::vector<Vec2> points;  ///< what stands there
};

Written section_in(const Dialect& dialect, Random& random) {
    const Header& header = headers[dialect.header];
    const std::string mark = separators[dialect.separator];
    const std::string end = line_ends[dialect.line_end];
    const auto row = [&](const std::string& id, const std::string& chainage, const std::string& elevation,
                         const std::string& name) {
        std::string text = dialect.extra == Extra::id_before ? cell(id, dialect) + mark : "";
        text += cell(chainage, dialect) + mark + cell(elevation, dialect);
        if (dialect.extra == Extra::name_behind || dialect.extra == Extra::remarks)
            text += mark + cell(name, dialect);
        return text + (dialect.trailing_separator ? mark : "") + end;
    };
    Written made;
    if (header.chainage[0] != '\0') made.text = row("Id", header.chainage, header.elevation, "Name");
    std::vector<std::string> rows;
    double chainage = dialect.stations ? uniform(random, 0, 3000) : uniform(random, -50, 1500);
    double elevation = uniform(random, -20, 1500);
    const int count = 2 + up_to(random, 10);
    for (int i = 0; i < count; ++i) {
        const std::string x = fmt::format("{:.{}f}", chainage, dialect.decimals);
        const std::string y = fmt::format("{:.{}f}", elevation, dialect.decimals);
        made.points.emplace_back(std::stod(x) * header.chainage_unit, std::stod(y) * header.elevation_unit);
        rows.push_back(
            row(fmt::format("P{}", i),
                dialect.stations ? station(chainage, dialect) : written(chainage, dialect, true),
                written(elevation, dialect, true),
                dialect.extra == Extra::remarks && up_to(random, 1) == 1 ? "" : fmt::format("n{}", i)));
        if (i == 0 || up_to(random, 9) > 0) chainage += uniform(random, 1.5, 40);
        elevation += uniform(random, 1.5, 90) * (elevation < -200 || up_to(random, 1) == 1 ? 1 : -1);
    }
    if (dialect.falling) std::ranges::reverse(rows);
    if (dialect.repeated_end) rows.push_back(rows.back());
    for (const std::string& text : rows) made.text += text;
    return made;
}

std::string encoded(const std::string& utf8, Encoding encoding) {
    if (encoding == Encoding::utf8) return utf8;
    if (encoding == Encoding::utf8_marked) return "\xEF\xBB\xBF" + utf8;
    const bool marked = encoding == Encoding::utf16_le_marked || encoding == Encoding::utf16_be_marked;
    const bool little = encoding == Encoding::utf16_le || encoding == Encoding::utf16_le_marked;
    std::string bytes = !marked ? "" : little ? "\xFF\xFE" : "\xFE\xFF";
    for (std::size_t i = 0; i < utf8.size(); ++i) {
        auto code = static_cast<unsigned char>(utf8[i]);
        // All letters here lie below U+0100.
        if (code >= 0x80)
            code = static_cast<unsigned char>(((code & 3U) << 6U) |
                                              (static_cast<unsigned char>(utf8[++i]) & 0x3FU));
        const char letter = static_cast<char>(code);
        if (encoding == Encoding::windows_1252)
            bytes += letter;
        else
            bytes += little ? std::string{letter, '\0'} : std::string{'\0', letter};
    }
    return bytes;
}

/// Dialects whose text leaves a choice, so that a refusal is right.
bool leaves_a_choice(const Dialect& dialect) {
    const bool headerless = headers[dialect.header].chainage[0] == '\0';
    const bool by_blanks = std::string(separators[dialect.separator]) == " ";
    if (headerless && dialect.extra != Extra::none) return true;
    // A row without its remark has one word less.
    if (by_blanks && dialect.extra == Extra::remarks) return true;
    // 1.234 alone may be either.
    const bool marks = dialect.thousands == Thousands::other_mark || dialect.decimals == 3;
    return marks && (dialect.decimals == 0 || dialect.decimals == 3);
}

class Dialects {
  public:
    void try_one(Dialect dialect, Random& random) {
        dialect.thousands = static_cast<Thousands>(up_to(random, 3));
        dialect.decimals = std::array{0, 1, 2, 3, 4, 6}[static_cast<std::size_t>(up_to(random, 5))];
        // Nobody who separates by commas writes 1.234 for a thousand and more.
        if (dialect.separator == 0 && dialect.comma && (dialect.decimals == 0 || dialect.decimals == 3))
            dialect.thousands = Thousands::none;
        dialect.falling = up_to(random, 3) == 0;
        dialect.repeated_end = up_to(random, 3) == 0;
        dialect.trailing_separator = up_to(random, 2) == 0;
        const Written section = section_in(dialect, random);
        SCOPED_TRACE(dialect.name() + "\n" + section.text);
        const std::string error = input_error([&] {
            expect_same(section_of_table(encoded(section.text, dialect.encoding), "section.csv", {}).points,
                        section.points);
        });
        ++tried;
        if (error.empty()) return;
        ++refused;
        EXPECT_TRUE(leaves_a_choice(dialect)) << error;
        EXPECT_TRUE(error.find("--columns") != std::string::npos ||
                    error.find("--decimal") != std::string::npos ||
                    error.find("same columns") != std::string::npos)
            << error;
    }

    int tried = 0;
    int refused = 0;

  private:
    static void expect_same(const std::vector<Vec2>& read, const std::vector<Vec2>& meant) {
        ASSERT_EQ(read.size(), meant.size());
        for (std::size_t i = 0; i < read.size(); ++i)
            ASSERT_LT((read[i] - meant[i]).cwiseAbs().maxCoeff(), 1e-9) << "point " << i;
    }
};

TEST(SectionDialect, EveryCombinationGivesTheSectionOrLeavesAChoice) {
    Random random(20);
    Dialects dialects;
    for (std::size_t separator = 0; separator < separators.size(); ++separator)
        for (const bool comma : {false, true})
            for (std::size_t header = 0; header < headers.size(); ++header)
                for (std::size_t line_end = 0; line_end < line_ends.size(); ++line_end)
                    for (int encoding = 0; encoding < 7; ++encoding)
                        for (int extra = 0; extra < 4; ++extra)
                            for (const bool stations : {false, true}) {
                                if (stations && headers[header].chainage_unit != 1) continue;
                                dialects.try_one(
                                    {separator, comma, header, line_end, static_cast<Encoding>(encoding),
                                     static_cast<Extra>(extra), stations},
                                    random);
                                if (testing::Test::HasFailure()) return;
                            }
    EXPECT_GT(dialects.tried, 7000);
    EXPECT_LT(dialects.refused, dialects.tried / 3);
}

}  // namespace
