#include "validation/poured_heap.h"

namespace runout {
namespace {

std::vector<PlannedRun> plan_nothing(bool) {
    return {};
}

CaseReport say_nothing(const CaseRuns&, const std::string&, bool) {
    return {};
}

}  // namespace

ValidationCase poured_heap_case() {
    return {"poured-heap", plan_nothing, say_nothing};
}

}  // namespace runout
