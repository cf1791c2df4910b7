#pragma once

#include <string>
#include <vector>

#include "report/page/page.h"
#include "store/store.h"

namespace runout {

/// Of several runs of one scenario the latest, in the order of their ids.
std::vector<StoredRun> latest_of_each_scenario(const std::vector<StoredRun>& runs);

/// Share of runs whose value is at least x, over x: a falling staircase. Values that are not finite are left
/// out.
std::vector<Vec2> exceedance(std::vector<double> values);

/// Many runs on one page: the table, normalised run-outs against drop height and front area, exceedance
/// curves. Runs that are not results are listed with their reason and are in no chart.
std::string study_page(const std::string& title, const std::vector<StoredRun>& runs);

}  // namespace runout
