#include "engine/simd/pair_kernels_impl.h"

namespace runout {

const PairKernels pair_kernels_avx2 = kernels::table();

}  // namespace runout
