#include "validation/suite.h"

#include <array>

#include "validation/suite_cases.h"

namespace runout {

std::span<const ValidationCase> validation_cases() {
    static const std::array cases = {
        numerics_case(),
        slab_case(),
        silo_case(),
        similarity_case(),
        dam_break_case(),
        aluminium_column_case(),
        poured_heap_case(),
        tall_columns_case(),
        column_run_out_case(),
        box_45_case(),
        box_70_case(),
        drop_height_case(),
        idealised_sources_case(),
    };
    return cases;
}

}  // namespace runout
