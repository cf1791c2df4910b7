// The aluminium-bar column of Bui et al. 2008 at dl = 2 mm and default settings against its measured surface.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "run/run_scene.h"
#include "scenes.h"

namespace runout {
namespace {

using Points = std::vector<Vec2>;

Points measured_surface() {
    std::ifstream file(RUNOUT_SOURCE_DIR "/cases/aluminium-column/expected.csv");
    Points points;
    for (std::string line; std::getline(file, line);) {
        std::istringstream fields(line);
        std::string name;
        std::string x;
        std::string y;
        std::getline(fields, name, ',');
        std::getline(fields, x, ',');
        std::getline(fields, y, ',');
        if (name == "surface") points.emplace_back(std::stod(x), std::stod(y));
    }
    return points;
}

/// Linear between points, level before the first, zero one `tail` after the last.
double value_at(const Points& points, double x, double tail) {
    if (x <= points.front().x()) return points.front().y();
    const auto next = std::find_if(points.begin(), points.end(), [&](const Vec2& p) { return p.x() >= x; });
    if (next == points.end()) {
        return points.back().y() * std::max(0.0, 1.0 - (x - points.back().x()) / tail);
    }
    const Vec2& b = *next;
    const Vec2& a = *(next - 1);
    return a.y() + (b.y() - a.y()) * (x - a.x()) / (b.x() - a.x());
}

Points thickness_by_top(const RunResult& result) {
    Points points;
    for (const DepositRow& row : result.deposit) points.emplace_back(row.chainage_m, row.thickness_by_top_m);
    return points;
}

/// integral |h - h_measured| dx / (L_0 H_0). The measured line ends at 1.5 mm height; its tail is closed with
/// the slope of its last stretch.
double misfit(const RunResult& result) {
    const Points measured = measured_surface();
    const Points computed = thickness_by_top(result);
    const double dx = 0.0005;
    double sum = 0.0;
    for (double x = 0.5 * dx; x < 0.7; x += dx) {
        sum += std::abs(value_at(computed, x, 2 * result.work.particle_spacing_m) -
                        value_at(measured, x, 0.0107)) *
               dx;
    }
    return sum / 0.02;
}

TEST(AluminiumColumn, FinalSurfaceAtThePapersFrictionAngle) {
    ASSERT_GT(measured_surface().size(), 20U);
    const RunResult result = run_scene(scenes::aluminium_column(21.9, 0.002));
    EXPECT_EQ(result.status, RunStatus::settled);
    EXPECT_EQ(result.work.particles, 5000);
    EXPECT_LT(misfit(result), 0.045);
    const double gate_height = value_at(thickness_by_top(result), 0.2, 0.004);
    EXPECT_NEAR(gate_height, 0.0474, 0.08 * 0.0474);
    EXPECT_GE(result.measures.run_out_m, 2.0 * 0.2);
    EXPECT_LE(result.measures.run_out_m, 2.25 * 0.2);
    EXPECT_LE(result.work.highest_density_ratio, 1.05);
    EXPECT_NEAR(result.measures.deposit_area_m2, 0.02, 0.02 * 0.02);
    RecordProperty("gate_height_m", std::to_string(gate_height));
    RecordProperty("misfit", std::to_string(misfit(result)));
}

TEST(AluminiumColumn, FinalSurfaceAtTheMeasuredFrictionAngle) {
    const RunResult result = run_scene(scenes::aluminium_column(19.8, 0.002));
    EXPECT_EQ(result.status, RunStatus::settled);
    EXPECT_LT(misfit(result), 0.08);
    RecordProperty("misfit", std::to_string(misfit(result)));
}

}  // namespace
}  // namespace runout
