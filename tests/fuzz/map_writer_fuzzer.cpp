#include <cstddef>
#include <cstdint>

#include "fuzz/targets.h"

/// GDAL 3.6 forgets its copy of a point, line or area one of whose latitudes it refuses.
extern "C" const char* __lsan_default_suppressions() {
    return "leak:OGR*::clone\n";
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    runout::fuzz::write_any_map({bytes, size});
    return 0;
}
