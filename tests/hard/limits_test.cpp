// Scenes that stand at a limit: of speed, of time, of size.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/simulation.h"
#include "hard/hard_scenes.h"
#include "observe.h"
#include "scene/make_problem.h"
#include "scenes.h"

namespace runout {
namespace {

double worst(const Simulation& simulation, Invariant invariant) {
    return simulation.invariants()[static_cast<std::size_t>(invariant)].worst;
}

/// A block that falls flat on level ground squeezes out jets that are faster than itself, while the energy of
/// the whole does not rise: free fall bounds the energy of the mass, and not the speed of each part.
TEST(Limits, JetsOfAnImpactAreFasterThanFreeFallAndTakeNoEnergyFromNowhere) {
    StressPoint p = plain_hard_point();
    p.source_kind = static_cast<double>(SourceKind::falling_block) + 0.5;
    p.friction_angle_deg = 5;
    p.drop_height_ratio = 20;
    const Scene scene = stress_scene(p, "jet");
    Simulation simulation(make_problem(scene));
    // The fall takes sqrt(2 * 20.5 sqrt(S)/g), and the jets a little more.
    while (simulation.status() == RunStatus::running && simulation.time() < 8.0 * simulation.time_scale())
        simulation.step();
    EXPECT_EQ(simulation.status(), RunStatus::running) << simulation.status_detail();
    EXPECT_GT(worst(simulation, Invariant::speed), 1.1);
    EXPECT_LT(worst(simulation, Invariant::energy_rise), 1e-3);
    EXPECT_LT(worst(simulation, Invariant::energy_balance), 1e-6);
    RecordProperty("speed", std::to_string(worst(simulation, Invariant::speed)));
    RecordProperty("energy_rise", std::to_string(worst(simulation, Invariant::energy_rise)));
}

/// Greatest displacement in spacings of a heap left alone for 300 sqrt(H/g).
double creep_of_heap(double slope_deg) {
    constexpr double height = 5.0;
    Scene scene = scenes::heap(slope_deg, height, 30.0, 0.35);
    scene.run.sleeping = false;  // friction alone must hold it
    Simulation simulation(make_problem(scene));
    const StateView start = simulation.state();
    std::vector<Vec2> from(start.x.size());
    for (std::size_t i = 0; i < from.size(); ++i) from[start.id[i]] = {start.x[i], start.y[i]};
    while (simulation.time() < 300.0 * std::sqrt(height / scene.run.gravity)) simulation.step();
    const StateView end = simulation.state();
    double moved = 0.0;
    for (std::size_t i = 0; i < from.size(); ++i)
        moved = std::max(moved, (Vec2{end.x[i], end.y[i]} - from[end.id[i]]).norm());
    return moved / 0.35;
}

TEST(Limits, HeapsBelowReposeStandForThreeHundredFallTimes) {
    // Repose of phi = 30 deg is 26.57 deg.
    for (const double slope : {15.0, 20.0, 24.0}) {
        const double creep = creep_of_heap(slope);
        EXPECT_LT(creep, 1.0) << "at " << slope << " deg";
        RecordProperty("creep_spacings_" + std::to_string(static_cast<int>(slope)), std::to_string(creep));
    }
}

std::vector<double> moved_spacings(const Simulation& simulation, const std::vector<Vec2>& start) {
    const std::vector<Vec2> end = positions_by_id(simulation);
    std::vector<double> moved;
    for (std::size_t i = 0; i < start.size(); ++i)
        moved.push_back((end[i] - start[i]).norm() / simulation.state().discretisation->spacing);
    return moved;
}

/// Nothing stops such a mass on level ground: it leaves the section, and the run says so.
TEST(Limits, MassesWithoutFrictionLeaveTheSectionWithEveryInvariantKept) {
    for (const bool base_only : {false, true}) {
        for (const SourceKind source :
             {SourceKind::rectangle, SourceKind::column, SourceKind::falling_block}) {
            SCOPED_TRACE(to_string(source) + (base_only ? ", no friction of the base" : ", no friction"));
            StressPoint p = plain_hard_point();
            p.source_kind = static_cast<double>(source) + 0.5;
            Scene scene = stress_scene(p, "frictionless");
            if (base_only)
                scene.effects.base_friction = BaseFriction{0.0};
            else
                scene.material.friction_angle = 0.0;
            Simulation simulation(make_problem(scene));
            while (simulation.status() == RunStatus::running) simulation.step();
            EXPECT_EQ(simulation.status(), RunStatus::left_section) << simulation.status_detail();
            for (int k = 0; k < static_cast<int>(Invariant::count); ++k)
                EXPECT_LE(worst(simulation, static_cast<Invariant>(k)),
                          simulation.invariants()[static_cast<std::size_t>(k)].limit)
                    << to_string(static_cast<Invariant>(k));
        }
    }
}

/// The base holds the wedge, and the soil is steeper at rest than the face. Once all soil within the kernel's
/// reach of the bed had the strength of the base: it flowed out at the foot, and the whole wedge came down
/// grain by grain.
TEST(Limits, AWedgeThatItsBaseHoldsStandsThoughItsFaceIsSteeperThanTheBaseCouldHold) {
    for (const double resolution : {12, 24}) {
        StressPoint p = plain_hard_point();
        p.source_kind = static_cast<double>(SourceKind::c) + 0.5;
        p.slope_angle_deg = 35;
        p.friction_angle_deg = 55;    // repose is 39.3 deg
        p.base_friction_share = 0.5;  // 27.5 deg
        p.base_angle_share = 0.6;     // 21 deg
        p.resolution = resolution;
        Simulation simulation(make_problem(stress_scene(p, "wedge")));
        const std::vector<Vec2> start = positions_by_id(simulation);
        while (simulation.status() == RunStatus::running) simulation.step();
        std::vector<double> moved = moved_spacings(simulation, start);
        std::ranges::sort(moved);
        // The tip of the wedge spills grains on to the face, where the base cannot hold them.
        EXPECT_LT(moved[moved.size() * 97 / 100], 1.0) << "at sqrt(S)/dl = " << resolution;
    }
}

/// 6 deg below repose: the lattice finds its rest, and then it stands.
TEST(FullLimits, TwoHundredThousandParticlesComeToRest) {
    Simulation simulation(make_problem(scenes::heap(20.0, 5.0, 30.0, 0.0131)));
    EXPECT_GE(simulation.state().x.size(), 200000U);
    while (simulation.status() == RunStatus::running) simulation.step();
    EXPECT_TRUE(is_result(simulation.status())) << simulation.status_detail();
    for (int k = 0; k < static_cast<int>(Invariant::count); ++k)
        EXPECT_LE(worst(simulation, static_cast<Invariant>(k)),
                  simulation.invariants()[static_cast<std::size_t>(k)].limit)
            << to_string(static_cast<Invariant>(k));
}

/// Above the toe, when 0.15 s have gone, J/m: by then half of the column has fallen.
double potential_energy_of_column(double resolution) {
    Scene scene = scenes::aluminium_column(21.9, 0);
    scene.run.particle_spacing = std::sqrt(scene.source.area) / resolution;
    Simulation simulation(make_problem(scene));
    while (simulation.status() == RunStatus::running && simulation.time() < 0.15) simulation.step();
    return simulation.energy().potential;
}

/// While the pressure of moving soil alternated from step to step it sank deeper the finer it was, by 20 % of
/// its height at sqrt(S)/dl = 256.
TEST(FullLimits, AFineColumnStandsAsHighAsACoarseOne) {
    const double share = potential_energy_of_column(181) / potential_energy_of_column(64);
    RecordProperty("share", std::to_string(share));
    EXPECT_NEAR(share, 1.0, 0.005);
}

}  // namespace
}  // namespace runout
