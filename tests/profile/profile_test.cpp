#include "profile/profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <concepts>
#include <filesystem>
#include <type_traits>

#include "core/units.h"
#include "profile/read_section_table.h"
#include "said.h"

using namespace runout;

namespace {

Profile profile_of(const std::vector<Vec2>& points, const ProfileOptions& options = {}) {
    return make_profile({points, {}, "section.csv"}, options);
}

const std::vector<Vec2> cut{{0, 32}, {30, 32}, {41.5, 12}, {200, 12}};

// ---- chainages and the local frame

template <class Point>
concept PlacedByAProfile = requires(const Profile& profile, const Point& point) {
    profile.to_local(point);
};
template <class A, class B>
concept Added = requires(const A& a, const B& b) {
    a + b;
};
template <class A, class B>
concept Compared = requires(const A& a, const B& b) {
    a < b;
};

// A chainage is no x, and a point of the file is no point of the local frame: only a profile turns one into
// the other.
static_assert(!std::is_convertible_v<double, Chainage> && !std::is_convertible_v<Chainage, double>);
static_assert(!std::is_assignable_v<double&, Chainage> && !std::is_assignable_v<Chainage&, double>);
static_assert(!Added<Chainage, double> && !Added<Chainage, Chainage> && !Compared<Chainage, double>);
static_assert(!std::is_constructible_v<SectionPoint, Vec2> && !std::is_constructible_v<Vec2, SectionPoint>);
static_assert(PlacedByAProfile<SectionPoint> && !PlacedByAProfile<Vec2>);

TEST(Chainage, ComparesAndHasDifferencesInMetres) {
    EXPECT_EQ(Chainage(41.5) - Chainage(40), 1.5);
    EXPECT_LT(Chainage(40), Chainage(41.5));
    const Chainage unknown;
    EXPECT_FALSE(unknown.is_known());
    EXPECT_FALSE(unknown < Chainage(0) || unknown > Chainage(0) || unknown == unknown);
}

TEST(Profile, PutsTheToeAtTheOriginAndRunsOutTowardsPlusX) {
    const Profile p = profile_of(cut);
    const Polyline expected{{-41.5, 20}, {-11.5, 20}, {0, 0}, {158.5, 0}};
    EXPECT_EQ(p.ground, expected);
    EXPECT_EQ(p.crest, 1u);
    EXPECT_EQ(p.toe, 2u);
    EXPECT_EQ(p.toe_chainage_m, 41.5);
    EXPECT_EQ(p.toe_elevation_m, 12);
    EXPECT_TRUE(p.descends_with_chainage);
    EXPECT_DOUBLE_EQ(p.slope_angle, std::atan2(20.0, 11.5));
    EXPECT_EQ(p.to_section({0, 0}), Vec2(41.5, 12));
    EXPECT_EQ(p.to_local({0, 32}), Vec2(-41.5, 20));
}

TEST(Profile, MirroredSectionHasTheSameLocalGroundToTheBit) {
    // Awkward decimals: an operation in another order would show in the last digit.
    const std::vector<Vec2> section{{0.1, 17.3}, {3.7, 16.9}, {11.3, 1.7}, {11.3, 0.3}, {50.9, 0.1}};
    std::vector<Vec2> mirrored;
    for (auto p = section.rbegin(); p != section.rend(); ++p) mirrored.emplace_back(-p->x(), p->y());
    ProfileOptions inserted;
    inserted.toe_chainage = Chainage(20.3);
    inserted.crest_chainage = Chainage(5.1);
    ProfileOptions inserted_mirrored;
    inserted_mirrored.toe_chainage = Chainage(-20.3);
    inserted_mirrored.crest_chainage = Chainage(-5.1);

    EXPECT_EQ(profile_of(section).ground, profile_of(mirrored).ground);
    const Profile a = profile_of(section, inserted);
    const Profile b = profile_of(mirrored, inserted_mirrored);
    EXPECT_EQ(a.ground, b.ground);
    EXPECT_EQ(a.toe, b.toe);
    EXPECT_EQ(a.crest, b.crest);
    EXPECT_TRUE(a.descends_with_chainage);
    EXPECT_FALSE(b.descends_with_chainage);
    EXPECT_EQ(a.to_section({2, 1}).x(), -b.to_section({2, 1}).x());
    const Vec2 there = b.to_section({2, 1});
    EXPECT_LT((b.to_local({there.x(), there.y()}) - Vec2(2, 1)).norm(), 1e-14);
    EXPECT_EQ(b.chainage_at(2), Chainage(there.x()));
}

TEST(Profile, MapGridChainagesLoseNothing) {
    std::vector<Vec2> far = cut;
    for (Vec2& p : far) p.x() += 8.3e5;
    const Profile p = profile_of(far);
    const Profile near = profile_of(cut);
    ASSERT_EQ(p.ground.size(), near.ground.size());
    for (std::size_t i = 0; i < p.ground.size(); ++i)
        EXPECT_EQ(p.ground[i], near.ground[i]);  // 41.5 is exact at 8.3e5
}

// ---- toe and crest

TEST(Profile, BermAndWallBelongToTheCut) {
    const Profile berm = profile_of({{0, 41}, {30, 35}, {36, 25}, {39, 24.9}, {45, 15}, {200, 15}});
    EXPECT_EQ(berm.crest, 1u);
    EXPECT_EQ(berm.toe, 4u);
    const Profile wall = profile_of({{0, 32}, {30, 32}, {39, 16}, {39, 12}, {200, 12}});
    EXPECT_EQ(wall.crest, 1u);
    EXPECT_EQ(wall.toe, 3u);
}

TEST(Profile, ThresholdIsHalfOfTheSteepestAndAtLeast15Degrees) {
    // Steepest 45 deg: 24 deg belongs to the face, 20 deg does not.
    const double slope_24 = std::tan(radians(24));
    const double slope_20 = std::tan(radians(20));
    EXPECT_EQ(profile_of({{0, 10 + 10 * slope_24}, {10, 10}, {20, 0}, {40, 0}}).crest, 0u);
    EXPECT_EQ(profile_of({{0, 10 + 10 * slope_20}, {10, 10}, {20, 0}, {40, 0}}).crest, 1u);
    // Steepest 14 deg: no face at all.
    const Profile gentle = profile_of({{0, 20 * std::tan(radians(14))}, {20, 0}, {40, 0}});
    EXPECT_EQ(gentle.crest, 0u);
    EXPECT_EQ(gentle.toe, 0u);
    EXPECT_EQ(gentle.slope_angle, 0);
}

TEST(Profile, SectionThatBeginsAtAWall) {
    const Profile p = profile_of({{0, 0.15}, {0, 0}, {1, 0}});
    EXPECT_EQ(p.crest, 0u);
    EXPECT_EQ(p.toe, 1u);
    EXPECT_EQ(p.ground.front(), Vec2(0, 0.15));
    EXPECT_DOUBLE_EQ(p.slope_angle, radians(90));
}

TEST(Profile, FlatBedHasToeAndCrestAtItsUphillEnd) {
    const Profile p = profile_of({{2, 5}, {3, 5}});
    EXPECT_TRUE(p.descends_with_chainage);
    EXPECT_EQ(p.toe, 0u);
    EXPECT_EQ(p.crest, 0u);
    EXPECT_EQ(p.ground.front(), Vec2(0, 0));
}

TEST(Profile, GivenToeAndCrestReplaceTheSearchAndAreInserted) {
    ProfileOptions options;
    options.crest_chainage = Chainage(10);
    options.toe_chainage = Chainage(35.75);
    const Profile p = profile_of(cut, options);
    ASSERT_EQ(p.ground.size(), 6u);
    EXPECT_EQ(p.crest, 1u);
    EXPECT_EQ(p.toe, 3u);
    EXPECT_EQ(p.ground[p.toe], Vec2(0, 0));
    EXPECT_DOUBLE_EQ(p.toe_elevation_m, 22);  // half-way down the face
    EXPECT_EQ(p.ground[p.crest], Vec2(-25.75, 10));
}

TEST(Profile, GivenToeAndCrestDecideTheDirection) {
    ProfileOptions options;
    options.crest_chainage = Chainage(20);
    options.toe_chainage = Chainage(10);
    const Profile p = profile_of({{0, 0}, {10, 0}, {20, 10}, {30, 10}, {60, -5}}, options);
    EXPECT_FALSE(p.descends_with_chainage);
    EXPECT_EQ(p.ground[p.crest], Vec2(-10, 10));
}

TEST(Profile, OnAVerticalFaceTheToeIsBelowAndTheCrestAbove) {
    ProfileOptions options;
    options.crest_chainage = Chainage(39);
    options.toe_chainage = Chainage(39);
    const Profile p = profile_of({{0, 32}, {30, 32}, {39, 16}, {39, 12}, {200, 12}}, options);
    EXPECT_EQ(p.ground[p.crest], Vec2(0, 4));
    EXPECT_EQ(p.ground[p.toe], Vec2(0, 0));
}

TEST(Profile, InnerPointsOfAVerticalFaceAreDropped) {
    const Profile p = profile_of({{0, 3}, {0, 2}, {0, 1}, {0, 0}, {5, 0}});
    const Polyline expected{{0, 3}, {0, 0}, {5, 0}};
    EXPECT_EQ(p.ground, expected);
}

TEST(Profile, RefusesWhatIsNoSection) {
    EXPECT_PRED2(contains, input_error([] { profile_of({}); }), "has no points");
    EXPECT_PRED2(contains, input_error([] { profile_of({{0, 0}}); }), "one point only");
    EXPECT_PRED2(contains, input_error([] { profile_of({{0, 3}, {1, 2}, {0.5, 1}}); }), "overhang");
    EXPECT_PRED2(contains, input_error([] {
                     profile_of({{0, 3}, {0, 3}, {1, 1}});
                 }),
                 "repeats the point before it");
    EXPECT_PRED2(contains, input_error([] {
                     profile_of({{0, 3}, {0, 1}, {0, 2}, {1, 1}});
                 }),
                 "goes up and down at the chainage 0");
    EXPECT_PRED2(contains, input_error([] {
                     profile_of({{0, -3}, {0, 31}, {6.6e-311, -23}, {2350, -2}});
                 }),
                 "goes up and down at the chainage 0");
    EXPECT_PRED2(contains, input_error([] { profile_of({{0, 3}, {1, 5}, {2, 3}}); }), "descends neither way");
    EXPECT_PRED2(contains, input_error([] {
                     profile_of({{0, 3}, {1, std::nan("")}, {2, 0}});
                 }),
                 "not a finite number");
    EXPECT_PRED2(contains, input_error([] { profile_of({{0, 3}, {INFINITY, 1}}); }), "not a finite number");
}

TEST(Profile, RefusesToeOrCrestBesideTheSection) {
    ProfileOptions options;
    options.toe_chainage = Chainage(201);
    EXPECT_PRED2(contains, input_error([&] { profile_of(cut, options); }),
                 "section.csv: section.toe_chainage_m = 201: is not on the section; give a chainage between "
                 "0 and 200");
    options = {};
    options.crest_chainage = Chainage(-1);
    std::vector<Vec2> mirrored;
    for (auto p = cut.rbegin(); p != cut.rend(); ++p) mirrored.emplace_back(300 - p->x(), p->y());
    EXPECT_PRED2(contains, input_error([&] { profile_of(mirrored, options); }),
                 "section.crest_chainage_m = -1: is not on the section; give a chainage between 100 and 300");
}

// ---- the shipped sections

/// The sections that a user starts from; the others belong to one case of the validation each.
bool is_cut(const std::string& name) {
    return name.starts_with("cut") || name.starts_with("box") || name.starts_with("fig15");
}

TEST(Profile, ShippedSectionsAreCutsWithRoomToRunOut) {
    int sections = 0;
    for (const auto& entry : std::filesystem::directory_iterator(RUNOUT_SOURCE_DIR "/profiles")) {
        if (entry.path().extension() != ".csv") continue;
        SCOPED_TRACE(entry.path().string());
        ++sections;
        const Profile p = make_profile(read_section_table(entry.path().string(), {}), {});
        const double height = p.ground[p.crest].y();
        EXPECT_GT(height, 0);
        if (is_cut(entry.path().stem().string())) {
            EXPECT_GE(p.ground.back().x(),
                      (entry.path().stem().string().starts_with("cut") ? 6 : 3) * height);
        }
    }
    EXPECT_GE(sections, 10);
}

}  // namespace
