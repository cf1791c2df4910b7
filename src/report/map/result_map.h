#pragma once

#include <string>
#include <vector>

#include "gis/map_layers.h"
#include "report/map/map_runs.h"
#include "report/text/intensity.h"

namespace runout {

struct MapOptions {
    bool every_run = false;           ///< not only the finest of each question
    double neighbours_within_m = 60;  ///< toes of neighbouring sections are no farther apart than this
    Intensities intensities{};
};

/// The map of a database, and what a reader of it must know that is not drawn, a sentence each.
struct ResultMap {
    MapSheet sheet;
    std::vector<std::string> remarks;
};

/// Layers `hazard_band`, `section`, `deposit`, `thickness`, `intensity`, `source`, `runout_extent_line`,
/// `runout_extent`, `place`, `reach_probability`, `reach_probability_line`, `failed_run` and `refused`, as
/// docs/maps.md describes them. Throws InputError when no run lies on a map.
ResultMap result_map(const Store& store, const MapOptions& options);

// ---- its parts

MapLayer section_layer(const MapRuns& runs);
MapLayer source_layer(const MapRuns& runs);
MapLayer deposit_layer(const MapRuns& runs);
MapLayer thickness_layer(const MapRuns& runs);
/// Classes of thickness and speed along the lines, their rank is 1 for the least.
MapLayer intensity_layer(const MapRuns& runs, const Intensities& intensities);
MapLayer extent_layer(const MapRuns& runs);
MapLayer extent_line_layer(const MapRuns& runs, const MapMetric& metric);
MapLayer failed_layer(const MapRuns& runs);
/// What arrives at the places that cases name: bars across the line, or stretches of it where they have a
/// width.
MapLayer place_layer(const MapRuns& runs, const MapMetric& metric);
/// Lines that were refused as input; one that cannot be drawn in the system of the map has attributes only.
MapLayer refused_layer(const std::vector<RefusedSection>& sections, const std::string& crs);

/// The ground between neighbouring sections from the heads of their sources to their distal margins, for
/// settled runs of the same scenario; of several on one section the one that goes farthest.
MapLayer hazard_band_layer(const MapRuns& runs, const MapMetric& metric, double within_m);

/// How probable it is that debris reaches a place: the share of the scenarios that were run for a section,
/// each with the same weight. One layer of stretches of the line, one of bars across it at 50, 10 and 1 %.
std::vector<MapLayer> probability_layers(const MapRuns& runs, const MapMetric& metric,
                                         std::vector<std::string>& remarks);

}  // namespace runout
