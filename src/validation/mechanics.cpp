#include "validation/mechanics.h"

namespace runout {
namespace {

std::vector<PlannedRun> plan_nothing(bool) {
    return {};
}

CaseReport say_nothing(const CaseRuns&, const std::string&, bool) {
    return {};
}

}  // namespace

ValidationCase slab_case() {
    return {"slab", plan_nothing, say_nothing};
}

ValidationCase silo_case() {
    return {"silo", plan_nothing, say_nothing};
}

ValidationCase dam_break_case() {
    return {"dam-break", plan_nothing, say_nothing};
}

ValidationCase similarity_case() {
    return {"similarity", plan_nothing, say_nothing};
}

}  // namespace runout
