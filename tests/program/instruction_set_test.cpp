// The same bits whatever the processor can do, and a sentence for what it cannot.

#include "engine/simd/instruction_set.h"

#include <cstdlib>

#include "program_fixture.h"

namespace runout {
namespace {

/// An environment variable of this process and of the programs it starts, while this object lives.
class Environment {
  public:
    Environment(const char* name, const std::string& value) : name_(name) { setenv(name, value.c_str(), 1); }
    ~Environment() { unsetenv(name_); }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

  private:
    const char* name_;
};

class InstructionSets : public ProgramTest, public testing::WithParamInterface<InstructionSet> {
  protected:
    /// What a run says of itself, without what differs from one hour to the next.
    [[nodiscard]] Json result_with(const std::string& set) const {
        const Environment wanted("RUNOUT_SIMD", set);
        const Outcome outcome = runout({"run", "case.toml", "--threads", "1", "--db", set + ".db", "--json"});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        const Json all = Json::parse(outcome.out);
        Json kept;
        for (const auto& [key, value] : all.items())
            if (key.find("wall") == key.npos && key.find("cpu") == key.npos && key.find("_utc") == key.npos &&
                key.find("memory") == key.npos && key != "run_id" && value.is_number())
                kept[key] = value;
        return kept;
    }
};

TEST_P(InstructionSets, GiveTheBitsOfTheBaseline) {
    if (!machine_has(GetParam())) GTEST_SKIP() << "this machine has no " << to_string(GetParam());
    const Json baseline = result_with("baseline");
    EXPECT_GT(baseline.size(), 20U) << baseline;
    EXPECT_EQ(result_with(to_string(GetParam())), baseline);
    const Environment wanted("RUNOUT_SIMD", to_string(GetParam()));
    EXPECT_TRUE(contains(runout({"--version"}).out, to_string(GetParam()) + " instructions"));
}

INSTANTIATE_TEST_SUITE_P(All, InstructionSets, testing::Values(InstructionSet::avx2, InstructionSet::avx512),
                         [](const auto& instance) { return to_string(instance.param); });

TEST_F(ProgramTest, UnknownInstructionSetsAreRefused) {
    for (const char* name : {"sse9", "AVX2", "avx2 "}) {
        const Environment wanted("RUNOUT_SIMD", name);
        expect_refused({"run", "case.toml"},
                       {fmt::format("RUNOUT_SIMD = {}: is no known", name), "baseline"});
    }
    const Environment none("RUNOUT_SIMD", "");
    EXPECT_EQ(runout({"--version"}).exit_code, 0);
}

TEST(InstructionSet, IsTheFastestUnlessItIsNamed) {
    EXPECT_EQ(instruction_set_named("baseline"), InstructionSet::baseline);
    const InstructionSet fastest = instruction_set_named("");
    EXPECT_TRUE(machine_has(fastest));
    for (const InstructionSet set : instruction_sets) {
        if (machine_has(set)) {
            EXPECT_GE(fastest, set);
            EXPECT_EQ(instruction_set_named(to_string(set)), set);
        } else {
            EXPECT_TRUE(contains(input_error([&] { instruction_set_named(to_string(set)); }),
                                 "is not what this machine can compute with"));
        }
    }
}

}  // namespace
}  // namespace runout
