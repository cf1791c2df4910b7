#include "validation/columns.h"

namespace runout {
namespace {

std::vector<PlannedRun> plan_nothing(bool) {
    return {};
}

CaseReport say_nothing(const CaseRuns&, const std::string&, bool) {
    return {};
}

}  // namespace

ValidationCase aluminium_column_case() {
    return {"aluminium-column", plan_nothing, say_nothing};
}

ValidationCase tall_columns_case() {
    return {"tall-columns", plan_nothing, say_nothing};
}

ValidationCase column_run_out_case() {
    return {"column-run-out", plan_nothing, say_nothing};
}

}  // namespace runout
