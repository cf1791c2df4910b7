#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gis/map_metric.h"
#include "store/store.h"

namespace runout {

/// A run with what a map needs of it.
struct MapRun {
    StoredRun run;
    RunPlace place;  ///< its line in the coordinate system of the map
    Question question;
    std::vector<DepositRow> deposit;
    std::optional<Envelope> envelope;  ///< none: the run is older than envelopes
    std::vector<Attribute>
        attributes;  ///< section, scenario, status and measures; a failed run has no measures
};

/// The runs of a database that lie on the map.
struct MapRuns {
    std::string crs;  ///< of the first section
    std::vector<MapRun> runs;
    int without_place = 0;  ///< runs left out, whose sections came from CSV files
};

/// Of runs that answer the same question about the same section and source, the one with the finest particles
/// is taken, the latest of equals; all of them if `every_run`. Throws InputError when there is none.
MapRuns map_runs(const Store& store, bool every_run);

/// Chainage at a horizontal distance beyond the toe; the end of the section beyond it.
double chainage_at_run_out(const RunPlace& place, double run_out_m);

/// Horizontal distance from the toe to the front at rest, also of a run of the former definition of the
/// front.
double run_out_from_toe(const MapRun& run);

/// Chainage of the distal margin of a settled run: at its run-out, or where the deposit ends that is
/// thicker than the threshold of the front when it does not pass the toe.
double distal_chainage(const MapRun& run);

/// Where the line has this chainage, and one metre across it to the left, in metres.
struct LinePlace {
    Vec2 at{0, 0};
    Vec2 left{0, 0};
};
LinePlace line_place(const MapLine& line, const MapMetric& metric, double chainage);

/// A bar across the line at a chainage, `half_length` metres to either side, in the coordinates of the map.
Polyline bar_across(const MapLine& line, const MapMetric& metric, double chainage, double half_length);

}  // namespace runout
