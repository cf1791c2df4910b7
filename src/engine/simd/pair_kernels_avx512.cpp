#include "engine/simd/pair_kernels_impl.h"

namespace runout {

const PairKernels pair_kernels_avx512 = kernels::table();

}  // namespace runout
