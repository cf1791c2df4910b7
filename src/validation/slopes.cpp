#include "validation/slopes.h"

namespace runout {
namespace {

std::vector<PlannedRun> plan_nothing(bool) {
    return {};
}

CaseReport say_nothing(const CaseRuns&, const std::string&, bool) {
    return {};
}

}  // namespace

ValidationCase box_45_case() {
    return {"box-45", plan_nothing, say_nothing};
}

ValidationCase box_70_case() {
    return {"box-70", plan_nothing, say_nothing};
}

ValidationCase drop_height_case() {
    return {"drop-height", plan_nothing, say_nothing};
}

ValidationCase idealised_sources_case() {
    return {"idealised-sources", plan_nothing, say_nothing};
}

}  // namespace runout
