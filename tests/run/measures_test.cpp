// What is read off a state, against states whose answer is known.

#include "measures/measures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "measures/deposit.h"
#include "run/run_scene.h"
#include "scenes.h"

namespace runout {
namespace {

/// A state made by hand: columns of lattice particles on a flat bed.
struct HandMade {
    Discretisation d = make_discretisation(0.01, 1.3, 2000);
    BedLine bed{Polyline{{-1, 1}, {0, 0}, {5, 0}}};
    std::vector<double> x, y, density;

    /// Rectangle of particles from x0 to x1, `rows` high.
    void add(double x0, double x1, int rows) {
        const long columns = std::lround((x1 - x0) / 0.01);
        for (long i = 0; i < columns; ++i) {
            for (int j = 0; j < rows; ++j) {
                x.push_back(x0 + (static_cast<double>(i) + 0.5) * 0.01);
                y.push_back((j + 0.5) * 0.01);
                density.push_back(1.0);
            }
        }
    }
    [[nodiscard]] StateView view() const {
        StateView state;
        state.discretisation = &d;
        state.bed = &bed;
        state.ground = &bed;
        state.x = x;
        state.y = y;
        state.density = density;
        return state;
    }
};

TEST(DepositTest, StepHasTheRightThicknessFrontAndArea) {
    HandMade soil;
    soil.add(0.0, 1.0, 10);
    const std::vector<char> body = connected_body(soil.view());
    const DepositProfile profile = deposit_profile(soil.view(), body);
    for (const auto& bin : profile.bins) {
        EXPECT_NEAR(bin.by_top, 0.1, 1e-12);
        if (bin.x > 0.05 && bin.x < 0.95) {
            EXPECT_NEAR(bin.by_mass, 0.1, 1e-12);
        }
    }
    EXPECT_NEAR(contiguous_front(profile, &DepositProfile::Bin::by_top, 0.05), 1.0, 0.01);
    EXPECT_NEAR(deposit_area(soil.view(), body), 0.1, 1e-12);
    EXPECT_NEAR(mass_front(soil.view(), 0.005), 0.995, 0.01);
}

TEST(DepositTest, GrainsApartDoNotCount) {
    HandMade soil;
    soil.add(0.0, 1.0, 10);
    soil.add(1.5, 1.52, 1);
    const std::vector<char> body = connected_body(soil.view());
    EXPECT_EQ(std::count(body.begin(), body.end(), 0), 2);
    EXPECT_NEAR(contiguous_front(deposit_profile(soil.view(), body), &DepositProfile::Bin::by_top, 0.005),
                1.0, 0.02);
}

// Debris that stops on a bench and below it: the part below was once called stray, and the run-out was that
// of the bench.
TEST(DepositTest, DistalPartOfADividedDepositHasTheFront) {
    HandMade soil;
    soil.add(0.0, 1.0, 10);
    soil.add(2.0, 2.5, 8);
    const std::vector<char> body = connected_body(soil.view());
    EXPECT_EQ(std::count(body.begin(), body.end(), 0), 0);
    const DepositProfile profile = deposit_profile(soil.view(), body);
    EXPECT_NEAR(contiguous_front(profile, &DepositProfile::Bin::by_top, 0.05), 2.5, 0.02);
    // Where the distal part is too thin to count, the one before it has the front.
    EXPECT_NEAR(contiguous_front(profile, &DepositProfile::Bin::by_top, 0.09), 1.0, 0.02);
}

TEST(DepositTest, ThinTailIsNotTheFrontOfAThickThreshold) {
    HandMade soil;
    soil.add(0.0, 1.0, 10);
    soil.add(1.0, 2.0, 1);
    const DepositProfile profile = deposit_profile(soil.view(), connected_body(soil.view()));
    EXPECT_NEAR(contiguous_front(profile, &DepositProfile::Bin::by_top, 0.03), 1.0, 0.02);
    EXPECT_NEAR(contiguous_front(profile, &DepositProfile::Bin::by_top, 0.005), 2.0, 0.02);
}

TEST(DepositTest, DistanceGoesAlongTheBed) {
    const BedLine bed({{-2, 2}, {0, 0}, {3, 0}, {4, -1}, {6, -1}});
    EXPECT_NEAR(distance_along_bed(bed, 2.0), 2.0, 1e-12);
    EXPECT_NEAR(distance_along_bed(bed, 5.0), 3.0 + std::sqrt(2.0) + 1.0, 1e-12);
    EXPECT_NEAR(distance_along_bed(bed, -1.0), -std::sqrt(2.0), 1e-12);
}

TEST(RunScene, MeasuresOfTheColumnAreConsistent) {
    const Scene scene = scenes::aluminium_column(21.9, 0.008);
    long reports = 0;
    const RunResult result = run_scene(scene, {[&](const Progress& p) {
                                                   ++reports;
                                                   EXPECT_GE(p.fraction, 0.0);
                                                   EXPECT_LE(p.fraction, 1.0);
                                               },
                                               nullptr});
    const Measures& m = result.measures;
    EXPECT_EQ(result.status, RunStatus::settled);
    EXPECT_NEAR(m.run_out_normalised, m.run_out_m / std::sqrt(m.deposit_area_m2), 1e-12);
    EXPECT_NEAR(m.reach_angle_deg, degrees(std::atan2(0.1, m.run_out_m - scene.source.head.x())), 1e-9);
    EXPECT_NEAR(m.source_area_m2, 0.02, 1e-15);
    EXPECT_GT(m.peak_front_speed_m_s, 0.3);
    EXPECT_LT(m.peak_front_speed_m_s, std::sqrt(2 * 9.81 * 0.1));
    EXPECT_GT(reports, 0);
    // Mass is exact at every sample.
    for (const SeriesRow& row : result.series) EXPECT_EQ(row.mass_kg_m, result.series.front().mass_kg_m);
    EXPECT_NEAR(result.series.front().mass_kg_m, 2079.5 * 0.02, 1e-9);
    // The profile by mass holds the mass of the connected deposit.
    double area = 0.0;
    for (const DepositRow& row : result.deposit)
        area += row.thickness_by_mass_m * 2 * result.work.particle_spacing_m;
    const double grain = result.work.particle_spacing_m * result.work.particle_spacing_m;
    EXPECT_NEAR(area, 0.02 - m.stray_particles * grain, 1e-9);
}

TEST(RunScene, SourceThatStandsHasNoRunOut) {
    const RunResult result = run_scene(scenes::heap(15.0, 0.1, 30.0, 0.005));
    EXPECT_EQ(result.status, RunStatus::stable);
    EXPECT_EQ(result.measures.run_out_m, 0.0);
    EXPECT_TRUE(std::isnan(result.measures.reach_angle_deg));
}

TEST(RunScene, StopsWhenTold) {
    const std::atomic<bool> stop{true};
    const RunResult result = run_scene(scenes::aluminium_column(21.9, 0.008), {{}, &stop});
    EXPECT_EQ(result.status, RunStatus::interrupted);
    EXPECT_EQ(result.work.steps, 0);  // stopped while the stress at release was still sought
}

TEST(MeasureFields, NamesAreUnique) {
    std::vector<std::string> names;
    for (const MeasureField& field : measure_fields()) names.emplace_back(field.name);
    std::sort(names.begin(), names.end());
    EXPECT_EQ(std::unique(names.begin(), names.end()), names.end());
    EXPECT_EQ(names.size() * sizeof(double), sizeof(Measures));
}

}  // namespace
}  // namespace runout
