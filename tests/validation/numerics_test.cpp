// The validation case "numerics", its quick part: the numerical method against exact solutions.

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "temporary_folder.h"
#include "validation/suite_cases.h"

namespace runout {
namespace {

/// The case plans no runs, so the store stays empty.
const CaseReport& report() {
    static const CaseReport made = [] {
        const TemporaryFolder folder;
        const Store store(folder.file("runs.db"), Store::Mode::write);
        return numerics_case().evaluate(CaseRuns(store, {}), "cases/numerics", true);
    }();
    return made;
}

/// What is known to miss its band; cases/numerics/README.md says why.
bool is_known_to_miss(const std::string& quantity) {
    static const std::set<std::string> known = {
        // The divergence is not renormalised: a lattice drawn out along its rows swells.
        "drop, lattice along the axes, R/dl = 24: short semi-axis / R",
        "drop, lattice along the axes, R/dl = 24: area from the semi-axes, over the start",
        // The pressure gradient is not consistent on uneven particles.
        "vortex, loss of kinetic energy in half a turn, observed order",
    };
    return known.contains(quantity);
}

TEST(Numerics, PlansNoRuns) {
    EXPECT_TRUE(numerics_case().plan(true).empty());
    EXPECT_TRUE(numerics_case().plan(false).empty());
}

TEST(Numerics, EveryEntryLiesWithinItsBandButThoseKnownToMiss) {
    int missed = 0;
    for (const ValidationEntry& entry : report().entries) {
        const bool known = is_known_to_miss(entry.quantity);
        EXPECT_EQ(within_band(entry), !known) << entry.quantity << ": " << entry.computed;
        missed += known ? 1 : 0;
    }
    EXPECT_EQ(missed, 3);
}

TEST(Numerics, EveryEntryHasANumberAndANameOfItsOwn) {
    std::set<std::string> names;
    for (const ValidationEntry& entry : report().entries) {
        EXPECT_TRUE(names.insert(entry.quantity).second) << entry.quantity;
        EXPECT_TRUE(std::isfinite(entry.computed)) << entry.quantity;
        EXPECT_EQ(entry.held_to, "exact");
        EXPECT_FALSE(entry.resolution.empty()) << entry.quantity;
    }
    EXPECT_GT(names.size(), 40U);
}

TEST(Numerics, FiguresHaveCurvesAndNamesOfTheirOwn) {
    std::set<std::string> names;
    for (const Figure& figure : report().figures) {
        EXPECT_TRUE(names.insert(figure.name).second) << figure.name;
        for (const Curve& curve : figure.curves) EXPECT_GE(curve.points.size(), 2U) << figure.name;
    }
    EXPECT_TRUE(names.contains("gradients"));
    EXPECT_TRUE(names.contains("drop"));
}

}  // namespace
}  // namespace runout
