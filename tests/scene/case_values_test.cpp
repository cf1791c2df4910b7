// Every key of a case with values of every type, size and sign: taken where the table says so, and otherwise
// refused in one sentence.

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "scene_fixture.h"

namespace runout {
namespace {

enum class Kind { number, text, numbers, pair, points, other };

/// A value as TOML has it, and what it is.
struct Sample {
    const char* toml;
    Kind kind;
    double number = std::nan("");
};

constexpr double inf = std::numeric_limits<double>::infinity();

const std::vector<Sample>& samples() {
    static const std::vector<Sample> all = {
        {"true", Kind::other},
        {"9007199254740993", Kind::number, 9007199254740992.0},  // the first that no double is
        {"9223372036854775807", Kind::number, 0x1p63},
        {"-9223372036854775808", Kind::number, -0x1p63},
        {"4294967296", Kind::number, 0x1p32},
        {"2147483648", Kind::number, 0x1p31},
        {"-1", Kind::number, -1},
        {"0", Kind::number, 0},
        {"-0.0", Kind::number, 0},
        {"1", Kind::number, 1},
        {"0.5", Kind::number, 0.5},
        {"nan", Kind::number, std::nan("")},
        {"inf", Kind::number, inf},
        {"-inf", Kind::number, -inf},
        {"1e308", Kind::number, 1e308},
        {"5e-324", Kind::number, 5e-324},
        {"\"x\"", Kind::text},
        {"\"\"", Kind::other},
        {"\"x\\u0000.csv\"", Kind::other},
        {"[1]", Kind::numbers},
        {"[1, 2]", Kind::pair},
        {"[9007199254740993, true]", Kind::other},
        {"[[1, 2]]", Kind::points},
        {"[[1, \"2\"]]", Kind::other},
        {"[[1, [2]]]", Kind::other},
        {"{ a = 1 }", Kind::other},
        {"1979-05-27", Kind::other},
        {"07:32:00", Kind::other},
    };
    return all;
}

/// What the table says of a value.
bool takes(const Parameter& parameter, const Sample& sample) {
    switch (parameter.kind) {
        case ValueKind::number:
            return sample.kind == Kind::number && std::isfinite(sample.number) &&
                   parameter.range.contains(sample.number);
        case ValueKind::integer:
            return sample.kind == Kind::number && std::isfinite(sample.number) &&
                   std::floor(sample.number) == sample.number && parameter.range.contains(sample.number);
        case ValueKind::text:
            return sample.kind == Kind::text;
        case ValueKind::choice:
            return false;
        case ValueKind::numbers:
            return sample.kind == Kind::numbers || sample.kind == Kind::pair;
        case ValueKind::place:
            return sample.kind == Kind::pair;
        case ValueKind::points:
            return sample.kind == Kind::points;
        case ValueKind::rows:
            return sample.kind == Kind::points && parameter.choices.size() == 2;
    }
    return false;
}

using CaseValues = SceneTest;

TEST_F(CaseValues, AreTakenWhereTheTableSaysSo) {
    int taken = 0;
    for (const Parameter& parameter : parameters()) {
        const std::string key(parameter.key);
        const std::size_t dot = key.rfind('.');
        for (const Sample& sample : samples()) {
            SCOPED_TRACE(fmt::format("{} = {}", key, sample.toml));
            const std::string file = write("one.toml", fmt::format("[{}]\n{} = {}\n", key.substr(0, dot),
                                                                   key.substr(dot + 1), sample.toml));
            const std::string said = input_error([&] { EXPECT_TRUE(read_case(file).has(key)); });
            EXPECT_EQ(said.empty(), takes(parameter, sample)) << said;
            if (!said.empty()) expect_complaint(said, {"one.toml, line 2: ", key});
            taken += said.empty() ? 1 : 0;
        }
    }
    EXPECT_GT(taken, 100);
}

// What is taken goes on to a scene or is refused there; nothing else may come of it.
TEST_F(CaseValues, MakeASceneOrASentence) {
    int scenes = 0;
    for (const Parameter& parameter : parameters()) {
        const std::string key(parameter.key);
        for (const Sample& sample : samples()) {
            if (!takes(parameter, sample) || key.starts_with("section.")) continue;
            SCOPED_TRACE(fmt::format("{} = {}", key, sample.toml));
            CaseSpec spec = sound_case();
            const std::string text = sample.kind == Kind::text ? "x" : sample.toml;
            const std::string said = input_error([&] {
                override_value(spec, key, text, "--set");
                make_scene(spec);
            });
            EXPECT_TRUE(said.empty() || said.size() > 20) << said;
            scenes += said.empty() ? 1 : 0;
        }
    }
    EXPECT_GT(scenes, 20);
}

TEST_F(CaseValues, WholeNumbersOfAnySizeAreThemselves) {
    const auto height = [&](const char* text) {
        const std::string file = write("a.toml", fmt::format("[effects.barrier]\nheight_m = {}\n", text));
        return read_case(file).effects.barrier->height;
    };
    EXPECT_EQ(height("9007199254740993"), 9007199254740992.0);
    EXPECT_EQ(height("9223372036854775807"), 0x1p63);
    EXPECT_EQ(height("1900"), 1900.0);
    const CaseSpec spec = read_case(
        write("a.toml",
              "[source]\ntype = \"polygon\"\npoints = [[9007199254740993, 0], [1, -9007199254740993]]\n"));
    EXPECT_EQ(spec.source.points,
              (std::vector<SectionPoint>{{9007199254740992.0, 0}, {1, -9007199254740992.0}}));
    expect_complaint(complaint("[run]\ngravity_m_s2 = 9007199254740993\n"),
                     {"bad.toml, line 2", "run.gravity_m_s2 = 9007199254740993", "out of range"});
    expect_complaint(complaint("[run]\nlattice_seed = 9007199254740993\n"), {"out of range"});
    expect_complaint(complaint("[run]\nlattice_seed = 99999999999999999999\n"), {"line 2", "not valid TOML"});
}

}  // namespace
}  // namespace runout
