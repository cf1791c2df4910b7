#include "validation/numerics.h"

namespace runout {
namespace {

std::vector<PlannedRun> plan_nothing(bool) {
    return {};
}

CaseReport say_nothing(const CaseRuns&, const std::string&, bool) {
    return {};
}

}  // namespace

ValidationCase numerics_case() {
    return {"numerics", plan_nothing, say_nothing};
}

}  // namespace runout
