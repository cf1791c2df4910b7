#include "engine/simd/instruction_set.h"
#include "engine/simd/pair_kernels_impl.h"

namespace runout {

const PairKernels pair_kernels_baseline = kernels::table();

const PairKernels& pair_kernels(InstructionSet set) {
    switch (set) {
        case InstructionSet::avx512:
            return pair_kernels_avx512;
        case InstructionSet::avx2:
            return pair_kernels_avx2;
        case InstructionSet::baseline:
            break;
    }
    return pair_kernels_baseline;
}

const PairKernels& pair_kernels() {
    static const PairKernels& chosen = pair_kernels(instruction_set());
    return chosen;
}

}  // namespace runout
