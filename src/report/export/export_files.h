#pragma once

#include <string>
#include <utility>
#include <vector>

#include "report/page/run_data.h"

namespace runout {

/// Name and text of each file.
using ExportFiles = std::vector<std::pair<std::string, std::string>>;

/// The particles over time for ParaView: a file of points for each stored instant (VTK XML PolyData: speed,
/// pressure) and particles.pvd, which lists them with their times; local frame, metres. From the snapshots if
/// the run has any (every particle, single precision, velocity too), else from the frames of the animation
/// (six bytes a particle, a part of them in large runs). Throws InputError when the run has neither.
ExportFiles vtk_files(const RunData& run, const std::vector<Snapshot>& snapshots);

/// series.csv, deposit.csv and, of a staged run, stages.csv; columns named as in the database.
ExportFiles csv_files(const RunData& run);

}  // namespace runout
