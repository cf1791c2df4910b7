#pragma once

#include <string>

namespace runout {

/// Model of the processor and number of hardware threads, such as "AMD EPYC 7763, 8 threads": timings of one
/// machine say little about another.
std::string machine_description();

/// Memory that programs may still take, MB; 0 where the system does not tell.
double available_memory_mb();

}  // namespace runout
