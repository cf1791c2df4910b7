#include "engine/pair_kernels_impl.h"

namespace runout {

const PairKernels pair_kernels_baseline = kernels::table();

const PairKernels& pair_kernels() {
#if defined(__x86_64__)
    static const bool has_avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                                   __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                                   __builtin_cpu_supports("avx512vl");
    static const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                                 __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
    if (has_avx512) return pair_kernels_avx512;
    if (has_avx2) return pair_kernels_avx2;
#endif
    return pair_kernels_baseline;
}

}  // namespace runout
