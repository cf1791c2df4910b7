#include "report/text/place_doubt.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace runout {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace

bool PlaceDoubt::within_error() const {
    return std::abs(beyond_front_m) <= error_m;
}

std::string PlaceDoubt::sentence() const {
    if (!within_error()) return reached ? "reached" : "not reached";
    return fmt::format("{}, but {:.2g} m {} the front is within its error of +-{:.2g} m",
                       reached ? "reached" : "not reached", std::abs(beyond_front_m),
                       reached ? "behind" : "beyond", error_m);
}

std::string PlaceDoubt::words() const {
    return fmt::format("{}{}", reached ? "reached" : "not reached", within_error() ? ", within error" : "");
}

PlaceDoubt place_doubt(const StoredRun& run, const PlaceRecord& place) {
    const double towards = run.crest_chainage_m > run.toe_chainage_m ? -1.0 : 1.0;
    const double past_toe = towards * (place.chainage_m - run.toe_chainage_m);
    return {std::isfinite(place.arrival_time_s), past_toe - run.measures.farthest_front_m,
            run.appraisal.run_out_error_m};
}

PlaceDoubt place_doubt(const ReachRow& row) {
    if (row.status == "stable") return {false, unknown, row.run_out_error_m};
    const double front = std::isfinite(row.farthest_front_m) ? row.farthest_front_m : row.run_out_m;
    return {row.reached(), row.from_toe_m - front, row.run_out_error_m};
}

}  // namespace runout
