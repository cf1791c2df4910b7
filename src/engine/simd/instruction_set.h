#pragma once

#include <array>
#include <string>

namespace runout {

/// Instruction sets for the pair loops. All give the same bits and differ in speed alone.
enum class InstructionSet { baseline, avx2, avx512 };

/// All of them, the fastest last.
inline constexpr std::array instruction_sets = {InstructionSet::baseline, InstructionSet::avx2,
                                                InstructionSet::avx512};

/// "baseline", "avx2", "avx512"
std::string to_string(InstructionSet set);

/// Whether processor and operating system have all that the pair loops of this set were compiled for.
bool machine_has(InstructionSet set);

/// The set of this name, or the fastest that the machine has where `name` is empty. Throws InputError for any
/// other name, and for a set that the machine lacks.
InstructionSet instruction_set_named(const std::string& name);

/// The set that this program uses: the one that the environment variable RUNOUT_SIMD names, else the fastest.
/// Throws as instruction_set_named.
InstructionSet instruction_set();

}  // namespace runout
