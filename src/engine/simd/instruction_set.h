#pragma once

#include <array>
#include <string>

namespace runout {

/// What the pair loops may be computed with. Every one gives the same bits; they differ in speed alone.
enum class InstructionSet { baseline, avx2, avx512 };

/// All of them, the fastest last.
inline constexpr std::array instruction_sets = {InstructionSet::baseline, InstructionSet::avx2,
                                                InstructionSet::avx512};

/// "baseline", "avx2", "avx512"
std::string to_string(InstructionSet set);

/// Whether processor and operating system have all that it was compiled for.
bool machine_has(InstructionSet set);

/// The one that is named, or the fastest that the machine has where `name` is empty. Throws InputError:
/// another name, or one that the machine lacks.
InstructionSet instruction_set_named(const std::string& name);

/// The one that this program uses: that of the environment variable RUNOUT_SIMD, if it is set. Throws
/// InputError as instruction_set_named.
InstructionSet instruction_set();

}  // namespace runout
