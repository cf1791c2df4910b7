// Files for ParaView and for spreadsheets.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <sstream>

#include "report/export/export_files.h"
#include "store_fixture.h"

namespace runout {
namespace {

class ExportTest : public StoreTest {
  protected:
    RunData stored(const RunResult& result) {
        const long id = add(example_scene(), result);
        return read_run_data(Store(path, Store::Mode::read), id);
    }
};

/// The numbers of the data array of that name.
std::vector<double> array_of(const std::string& file, const std::string& name) {
    const std::size_t start = file.find('>', file.find("Name=\"" + name + "\"")) + 1;
    std::istringstream words(file.substr(start, file.find('<', start) - start));
    std::vector<double> values;
    for (double value = 0; words >> value;) values.push_back(value);
    return values;
}

TEST_F(ExportTest, SnapshotsBecomeFilesOfPointsAndAList) {
    const RunResult result = example_result();
    const ExportFiles files = vtk_files(stored(result), result.snapshots);
    ASSERT_EQ(files.size(), 3u);
    EXPECT_EQ(files[0].first, "particles_0000.vtp");
    EXPECT_EQ(files[2].first, "particles.pvd");
    EXPECT_TRUE(contains(files[2].second, "timestep=\"0.25\" file=\"particles_0000.vtp\""));
    EXPECT_TRUE(contains(files[0].second, "NumberOfPoints=\"2\""));
    EXPECT_EQ(array_of(files[0].second, "position_m"), (std::vector<double>{1.5, 0.5, 0, 2.25, 0.1, 0}));
    EXPECT_EQ(array_of(files[0].second, "velocity_m_s").size(), 6u);
    EXPECT_NEAR(array_of(files[0].second, "speed_m_s")[0], 3.3, 1e-6);
    EXPECT_EQ(array_of(files[0].second, "connectivity"), (std::vector<double>{0, 1}));
    EXPECT_EQ(array_of(files[0].second, "offsets"), (std::vector<double>{1, 2}));
    EXPECT_TRUE(contains(files[1].second, "NumberOfPoints=\"0\""));
}

TEST_F(ExportTest, WithoutSnapshotsTheFramesServe) {
    RunResult result = example_result();
    result.snapshots.clear();
    const ExportFiles files = vtk_files(stored(result), {});
    ASSERT_EQ(files.size(), 3u);
    const FrameScale& scale = result.frames[0].scale;
    const auto points = array_of(files[0].second, "position_m");
    EXPECT_NEAR(points[0], scale.x_low_m, 1e-6);
    EXPECT_NEAR(points[3], scale.x_low_m + 65535 * scale.x_step_m, 1e-2);
    EXPECT_NEAR(array_of(files[0].second, "pressure_pa")[1],
                scale.pressure_low_pa + 254 * scale.pressure_step_pa, 1);
}

TEST_F(ExportTest, ARunWithNeitherIsRefused) {
    RunResult result = example_result();
    result.frames.clear();
    const RunData run = stored(result);
    EXPECT_TRUE(
        contains(input_error([&] { static_cast<void>(vtk_files(run, {})); }), "has no particles stored"));
}

TEST_F(ExportTest, TablesReadBackToTheBit) {
    const RunResult result = example_result();
    const ExportFiles files = csv_files(stored(result));
    ASSERT_EQ(files.size(), 3u);
    EXPECT_EQ(files[0].first, "series.csv");
    EXPECT_TRUE(files[0].second.starts_with("time_s,front_mass_995_m,kinetic_energy_j_m,"));
    EXPECT_TRUE(contains(files[0].second, fmt::format("\n{},{},", result.series[1].time_s,
                                                      result.series[1].front_mass_995_m)));
    EXPECT_TRUE(contains(files[1].second, "834510.25,43.1,0.3,0.4\n"));
    EXPECT_EQ(files[2].first, "stages.csv");
}

}  // namespace
}  // namespace runout
