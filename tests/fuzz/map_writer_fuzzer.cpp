#include <cstddef>
#include <cstdint>

#include "fuzz/targets.h"

/// GDAL 3.6 forgets its copy of a point, line or area one of whose latitudes it refuses, and GEOS 3.11 what
/// it was snapping when an area turns out to be none; so does GDAL then with the area that it was to become.
extern "C" const char* __lsan_default_suppressions() {
    return "leak:OGR*::clone\nleak:geos::noding::\nleak:OGRGeometryFactory::createGeometry\n";
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    runout::fuzz::write_any_map({bytes, size});
    return 0;
}
