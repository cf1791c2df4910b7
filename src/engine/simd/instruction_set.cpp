#include "engine/simd/instruction_set.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "core/input_error.h"
#include "engine/simd/processor_checks.h"

namespace runout {
namespace {

constexpr const char* variable = "RUNOUT_SIMD";

std::string names_of_those_here() {
    std::string names;
    for (const InstructionSet set : instruction_sets)
        if (machine_has(set)) names += (names.empty() ? "" : ", ") + to_string(set);
    return names;
}

}  // namespace

std::string to_string(InstructionSet set) {
    switch (set) {
        case InstructionSet::baseline:
            return "baseline";
        case InstructionSet::avx2:
            return "avx2";
        case InstructionSet::avx512:
            return "avx512";
    }
    return "unknown";
}

bool machine_has(InstructionSet set) {
    switch (set) {
        case InstructionSet::baseline:
            return true;
        case InstructionSet::avx2:
            return processor::has_avx2();
        case InstructionSet::avx512:
            return processor::has_avx512();
    }
    return false;
}

InstructionSet instruction_set_named(const std::string& name) {
    const InputPlace place{.file = {}, .line = 0, .key = variable, .value = name};
    const std::string valid = fmt::format("on this machine: {}; or leave it out", names_of_those_here());
    if (name.empty()) return *std::find_if(instruction_sets.rbegin(), instruction_sets.rend(), machine_has);
    const auto* const found = std::ranges::find(instruction_sets, name, to_string);
    if (found == instruction_sets.end()) throw InputError(place, "is no known instruction set", valid);
    if (!machine_has(*found)) throw InputError(place, "is not what this machine can compute with", valid);
    return *found;
}

InstructionSet instruction_set() {
    static const InstructionSet chosen = [] {
        const char* const name = std::getenv(variable);
        return instruction_set_named(name == nullptr ? "" : name);
    }();
    return chosen;
}

}  // namespace runout
