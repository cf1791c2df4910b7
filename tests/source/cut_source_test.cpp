// The shapes that lie on a face: types C, B, the rectangle and type A.

#include "source_fixture.h"

namespace runout {
namespace {

// ---- Fig. 15 and type C

TEST(TypeC, Fig15) {
    const Profile profile = shipped("fig15.csv");
    const Source s = derive_source(profile, fig15());
    EXPECT_NEAR(s.area, 0.0043, 0.0043e-12);
    EXPECT_NEAR(s.front_area / s.area, 0.68782, 5e-6);
    EXPECT_NEAR(s.head.y() - s.exit_point.y(), 0.15, 1e-15);
    EXPECT_NEAR(s.exit_point.x() - s.head.x(), 0.075629, 5e-7);
    const Vec2 foot = s.exit_point + 0.068495 * Vec2(-std::cos(base_angle), std::sin(base_angle));
    EXPECT_LT(distance_to_corner(s.outline, foot), 1e-6);
    EXPECT_EQ(s.outline.size(), 4u);
    EXPECT_EQ(s.drop_height, s.head.y());
    EXPECT_NEAR(s.drop_height / std::sqrt(s.area), 5.86, 0.005);
    expect_cut_from_ground(s, profile);
}

TEST(TypeC, WithoutHeightDaylightsAtTheToe) {
    SourceSpec spec = fig15();
    spec.height = SourceSpec::unset;
    spec.area = 0.03;
    const Profile profile = shipped("fig15.csv");
    const Source s = derive_source(profile, spec);
    EXPECT_EQ(s.exit_point, Vec2(0, 0));
    EXPECT_NEAR(s.area, 0.03, 0.03e-12);
    expect_cut_from_ground(s, profile);
}

TEST(TypeC, DropHeightToTheBasePlacesP) {
    SourceSpec spec = fig15();
    spec.height = SourceSpec::unset;
    spec.datum = DropDatum::base;
    spec.drop_height = 0.384 - 0.15;
    const Source s = derive_source(shipped("fig15.csv"), spec);
    EXPECT_NEAR(s.front_area / s.area, 0.68782, 5e-6);
    EXPECT_DOUBLE_EQ(s.drop_height, 0.234);
}

TEST(TypeC, ScarpTopLiesBehindTheCrestEdgeAndOnTheSection) {
    const Profile profile = shipped("fig15.csv");
    SourceSpec spec = fig15();
    spec.area = 0.001794;  // just below the triangle of type B with its apex at the crest
    EXPECT_PRED2(contains, error_of(profile, spec),
                 "source.area_m2 = 0.001794: puts the back scarp on the face");
    EXPECT_PRED2(contains, error_of(profile, spec), "give more than 0.00179456");
    spec.area = 0.1;
    EXPECT_PRED2(
        contains, error_of(profile, spec),
        "is more than base and back scarp cut off on this section; give more than 0.00179456 and at most")
        << error_of(profile, spec);
    spec.area = SourceSpec::unset;
    EXPECT_PRED2(contains, error_of(profile, spec), "source.area_m2: is missing for a source of type C");
    spec = fig15();
    spec.height = 0.4;
    EXPECT_PRED2(contains, error_of(profile, spec),
                 "source.height_m = 0.4: puts the lower end of the source below");
    spec = fig15();
    spec.drop_height = 0.3;
    EXPECT_PRED2(contains, error_of(profile, spec), "source.drop_height_m = 0.3: contradicts");
    EXPECT_PRED2(contains, error_of(shipped("box-70.csv"), fig15()), "needs ground behind the crest");
}

// ---- type B

TEST(TypeB, IsTheTriangleOfItsHeight) {
    const Profile profile = cut(face_angle, 0.4, 0.3, 1.5);
    SourceSpec spec = type_b();
    spec.height = 0.15;
    const Source s = derive_source(profile, spec);
    const double expected = triangle_area(0.15 / std::sin(face_angle), base_angle, face_angle, scarp_angle);
    EXPECT_NEAR(expected, 0.001795, 5e-7);
    EXPECT_NEAR(s.area, expected, 1e-13 * expected);
    EXPECT_EQ(s.outline.size(), 3u);
    EXPECT_EQ(s.exit_point, Vec2(0, 0));
    EXPECT_NEAR(s.head.y(), 0.15, 1e-16);
    expect_cut_from_ground(s, profile);
}

TEST(TypeB, FrontAreaIsTheTriangleAboveTheDiscontinuity) {
    SourceSpec spec = type_b();
    spec.height = 0.15;
    for (const double theta : {40.0, 55.0, 69.0, 75.0}) {
        spec.discontinuity_angle = radians(theta);
        const Source s = derive_source(cut(face_angle, 0.4, 0.3, 1.5), spec);
        const double side = 0.15 / std::sin(face_angle);
        const double expected =
            theta < 70 ? triangle_area(side, radians(theta), face_angle, scarp_angle) : 0.0;
        EXPECT_NEAR(s.front_area, expected, 1e-12 * s.area) << theta;
    }
}

TEST(TypeB, WithoutMeasuresTakesTheWholeFace) {
    const Profile profile = cut(radians(60), 20, 30, 160);
    const Source s = derive_source(profile, type_b());
    EXPECT_EQ(s.exit_point, Vec2(0, 0));
    EXPECT_EQ(s.head, profile.ground[profile.crest]);
    EXPECT_EQ(s.drop_height, 20);
    expect_cut_from_ground(s, profile);
}

TEST(TypeB, HasTheAreaAskedFor) {
    for (const std::string name :
         {"cut-60.csv", "cut-70.csv", "cut-wall.csv", "cut-berm.csv", "cut-map-grid.csv"}) {
        SCOPED_TRACE(name);
        const Profile profile = shipped(name);
        SourceSpec spec = type_b();
        const double greatest = derive_source(profile, spec).area;
        for (const double share : {1.0, 0.9, 0.5, 0.3}) {
            spec.area = share * greatest;
            const Source s = derive_source(profile, spec);
            EXPECT_NEAR(s.area, spec.area, 1e-13 * spec.area) << share;
            expect_cut_from_ground(s, profile);
        }
        spec.area = 1.001 * greatest;
        EXPECT_PRED2(contains, error_of(profile, spec), "puts the apex above the crest; give at most ");
    }
}

TEST(TypeB, DropHeightPlacesTheHead) {
    const Profile profile = cut(face_angle, 0.4, 0.3, 1.5);
    SourceSpec spec = type_b();
    spec.drop_height = 0.3;
    EXPECT_EQ(derive_source(profile, spec).exit_point, Vec2(0, 0));
    spec.height = 0.1;
    const Source by_height = derive_source(profile, spec);
    EXPECT_NEAR(by_height.head.y(), 0.3, 1e-15);
    EXPECT_NEAR(by_height.exit_point.y(), 0.2, 1e-15);
    spec.height = SourceSpec::unset;
    spec.area = by_height.area;
    const Source by_area = derive_source(profile, spec);
    EXPECT_NEAR(by_area.area, spec.area, 1e-13 * spec.area);
    EXPECT_NEAR(by_area.exit_point.y(), 0.2, 1e-12);
    EXPECT_NEAR(by_area.drop_height, 0.3, 1e-15);
}

TEST(TypeB, DropHeightToTheBasePlacesP) {
    const Profile profile = cut(face_angle, 0.4, 0.3, 1.5);
    SourceSpec spec = type_b();
    spec.datum = DropDatum::base;
    spec.drop_height = 0.1;
    const Source whole = derive_source(profile, spec);
    EXPECT_NEAR(whole.exit_point.y(), 0.1, 1e-15);
    EXPECT_EQ(whole.head, profile.ground[profile.crest]);
    EXPECT_EQ(whole.drop_height, whole.exit_point.y());
    spec.height = 0.2;
    EXPECT_NEAR(derive_source(profile, spec).head.y(), 0.3, 1e-15);
}

TEST(TypeB, VerticalScarpIsVertical) {
    SourceSpec spec = type_b();
    spec.scarp_angle = radians(90);
    spec.height = 0.15;
    const Profile profile = cut(face_angle, 0.4, 0.3, 1.5);
    const Source s = derive_source(profile, spec);
    EXPECT_TRUE(std::ranges::any_of(
        s.outline, [&](const Vec2& p) { return p.x() == s.head.x() && p.y() < 0.15 - 1e-3; }));
    expect_cut_from_ground(s, profile);
}

TEST(TypeB, RefusesWhatTheFaceCannotHold) {
    const Profile profile = cut(face_angle, 0.4, 0.3, 1.5);
    SourceSpec spec = type_b();
    spec.height = 0.41;
    EXPECT_PRED2(contains, error_of(profile, spec),
                 "source.height_m = 0.41: puts the apex 0.41 m above the toe, above the crest at 0.4 m; give "
                 "at most 0.4 m");
    spec = type_b();
    spec.area = 0.0128;
    EXPECT_PRED2(contains, error_of(profile, spec),
                 "source.area_m2 = 0.0128: puts the apex above the crest; give at most 0.01276");
    spec.drop_height = 0.3;
    EXPECT_PRED2(contains, error_of(profile, spec),
                 "puts the lower end of the source below the toe; give at most 0.00717823");
    spec = type_b();
    spec.height = 0.15;
    spec.area = 0.0043;
    EXPECT_PRED2(contains, error_of(profile, spec), "source.area_m2 = 0.0043: contradicts source.height_m");
    EXPECT_PRED2(contains, error_of(profile, spec), "with this height the area is 0.00179456");
    spec = type_b();
    spec.scarp_angle = radians(65);
    EXPECT_PRED2(contains, error_of(profile, spec),
                 "source.scarp_angle_deg = 65: is not steeper than the face; give more than 70 and at most "
                 "90 degrees");
    spec = type_b();
    spec.base_angle = radians(72);
    EXPECT_PRED2(contains, error_of(profile, spec),
                 "source.base_angle_deg = 72: is not flatter than the face; give less than 70");
    spec = type_b();
    spec.drop_height = 0.5;
    EXPECT_PRED2(contains, error_of(profile, spec),
                 "source.drop_height_m = 0.5: puts the head of the source 0.5 m above the toe");
    spec.drop_height = 0.1;
    spec.height = 0.2;
    EXPECT_PRED2(contains, error_of(profile, spec),
                 "source.height_m = 0.2: puts the lower end of the source 0.1 m below the toe");
    spec.drop_height = 0;
    spec.height = SourceSpec::unset;
    EXPECT_PRED2(contains, error_of(profile, spec), "leaves no room");
    spec.datum = DropDatum::base;
    spec.drop_height = 0.4;
    EXPECT_PRED2(contains, error_of(profile, spec), "puts the lower end of the source at the crest");
}

TEST(TypeB, BaseThatRunsIntoABermIsRefused) {
    // From P just under the berm, a base of 35 deg comes out on the berm before the upper batter.
    const Profile profile = shipped("cut-berm.csv");
    SourceSpec spec = type_b();
    spec.datum = DropDatum::base;
    spec.drop_height = 9.5;
    EXPECT_PRED2(contains, error_of(profile, spec), "finds no connected mass");
}

// ---- rectangle and type A

TEST(TypeB, OnLevelGroundSaysWhereItsBaseCouldBegin) {
    ProfileOptions options;
    options.toe_chainage = Chainage(45);
    const Profile profile =
        make_profile({{{0, 32}, {30, 32}, {41.547, 12}, {201, 12}}, {}, "section.csv"}, options);
    for (const double area : {SourceSpec::unset, 20.0}) {
        SourceSpec spec = type_b();
        spec.area = area;
        const std::string error = error_of(profile, spec);
        EXPECT_PRED2(contains, error, "exit point P at [45, 12]");
        EXPECT_PRED2(contains, error,
                     "foot of the steep part, [41.547, 12]: give section.toe_chainage_m = 41.547");
        EXPECT_FALSE(contains(error, "at most 0")) << error;
    }
}

TEST(TypeB, OnABermSaysWhereItsBaseCouldBegin) {
    const Profile profile = shipped("cut-berm.csv");
    SourceSpec spec = type_b();
    spec.datum = DropDatum::base;
    spec.drop_height = 9.9;  // the outer edge of the berm
    spec.area = 10;
    const std::string error = error_of(profile, spec);
    EXPECT_PRED2(contains, error, "flatter than the base");
    EXPECT_PRED2(contains, error, "source.drop_height_m = 10 with source.drop_height_datum = base");
    EXPECT_FALSE(contains(error, "at most 0")) << error;
    spec.drop_height = 10;
    EXPECT_NO_THROW(derive_source(profile, spec));
}

TEST(TypeB, AnExitPointThatMissesTheFootByAReadingErrorIsMended) {
    const Profile profile =
        profile_of({{0, 40}, {20, 40}, {26, 30}, {29, 29.9}, {29.04, 29.89}, {35, 20}, {120, 20}});
    SourceSpec spec = type_b();
    spec.datum = DropDatum::base;
    spec.drop_height = 9.89;
    spec.area = 3;
    EXPECT_PRED2(contains, error_of(profile, spec), "flatter than the base");  // 3 m of berm above it
    const Profile notched = profile_of({{0, 40}, {30, 40}, {41.5, 20.01}, {41.54, 20}, {120, 20}});
    EXPECT_NO_THROW(derive_source(notched, type_b()));
}

TEST(TypeB, OnAVerticalWallCutsWhatLiesAboveItsBase) {
    const Profile profile = shipped("cut-wall.csv");
    for (const double height : {0.5, 2.0, 3.5}) {
        SourceSpec spec = type_b();
        spec.datum = DropDatum::base;
        spec.drop_height = height;
        const Source source = derive_source(profile, spec);
        EXPECT_NEAR(source.exit_point.y(), height, 1e-12);
        expect_cut_from_ground(source, profile);
    }
}

TEST(Rectangle, LiesOnTheFaceWithItsHeadAtTheCrest) {
    const Profile profile = shipped("box-70.csv");
    const Source s = derive_source(profile, box(0.1, 0.05));
    EXPECT_NEAR(s.area, 0.005, 1e-15 * 0.005);
    EXPECT_LT((s.head - profile.ground[profile.crest]).norm(), 1e-16);
    EXPECT_NEAR(s.head.y() - s.exit_point.y(), 0.1 * std::sin(face_angle), 1e-13);
    EXPECT_EQ(s.front_area / s.area, 1.0);  // the face is steeper than 55 deg
    EXPECT_EQ(s.bed, profile.ground);
    EXPECT_NEAR(signed_area(s.outline), 0.005, 1e-15);
}

TEST(Rectangle, FrontOnAFlatterFaceIsWhatTheLineLeaves) {
    const Source s = derive_source(shipped("box-45.csv"), box(0.1, 0.05));
    // The line through the lower corner rises 10 deg from the base.
    EXPECT_NEAR(s.front_area, 0.005 - 0.1 * 0.1 * std::tan(radians(10)) / 2, 1e-15);
    EXPECT_EQ(s.bed, shipped("box-45.csv").ground);
}

TEST(Rectangle, DropHeightPlacesHeadOrBase) {
    const Profile profile = shipped("box-45.csv");
    SourceSpec spec = box(0.1, 0.05);
    spec.drop_height = 0.3;
    const Source head = derive_source(profile, spec);
    EXPECT_NEAR(head.head.y(), 0.3, 1e-15);
    EXPECT_NEAR(head.drop_height, 0.3, 1e-15);
    spec.datum = DropDatum::base;
    const Source base = derive_source(profile, spec);
    EXPECT_NEAR(base.exit_point.y(), 0.3, 1e-15);
    EXPECT_NEAR(base.head.y(), 0.3 + 0.1 * std::sin(radians(45)), 1e-15);
    EXPECT_NEAR(base.drop_height, 0.3, 1e-15);
}

TEST(Rectangle, AnyTwoMeasuresMakeTheSameBox) {
    const Profile profile = shipped("box-45.csv");
    const Polygon expected = derive_source(profile, box(0.1, 0.05)).outline;
    const std::vector<std::pair<double SourceSpec::*, double>> measures{{&SourceSpec::length, 0.1},
                                                                        {&SourceSpec::thickness, 0.05},
                                                                        {&SourceSpec::aspect, 2},
                                                                        {&SourceSpec::area, 0.005}};
    for (std::size_t i = 0; i < measures.size(); ++i)
        for (std::size_t k = i + 1; k < measures.size(); ++k) {
            SourceSpec spec;
            spec.type = SourceType::rectangle;
            spec.*measures[i].first = measures[i].second;
            spec.*measures[k].first = measures[k].second;
            const Polygon outline = derive_source(profile, spec).outline;
            ASSERT_EQ(outline.size(), 4u);
            for (std::size_t c = 0; c < 4; ++c) EXPECT_LT((outline[c] - expected[c]).norm(), 1e-15);
        }
}

TEST(Rectangle, RefusesTooFewContradictoryOrTooLong) {
    const Profile profile = shipped("box-45.csv");
    SourceSpec spec = box(0.1, SourceSpec::unset);
    EXPECT_PRED2(contains, error_of(profile, spec),
                 "source.length_m: is missing, and one measure alone makes no box");
    spec = box(0.1, 0.05);
    spec.area = 0.006;
    EXPECT_PRED2(
        contains, error_of(profile, spec),
        "source.area_m2 = 0.006: contradicts the other measures of the box; leave it out or give 0.005");
    spec.area = 0.005;
    EXPECT_EQ(error_of(profile, spec), "");
    spec.aspect = 3;
    EXPECT_PRED2(contains, error_of(profile, spec), "source.aspect_ratio = 3: contradicts");
    EXPECT_PRED2(contains, error_of(profile, box(0.6, 0.05)),
                 "source.length_m = 0.6: makes the box 0.6 m long, too long");
    EXPECT_PRED2(contains, error_of(profile, box(0.6, 0.05)), "at most 0.565685 m fit there");
    // Across a berm there is no straight face.
    EXPECT_PRED2(contains, error_of(shipped("cut-berm.csv"), box(12, 1)), "too long for the straight part");
    spec = box(0.1, 0.05);
    spec.drop_height = 0.05;
    EXPECT_PRED2(contains, error_of(profile, spec), "at most 0.0707107 m fit there");
}

TEST(TypeA, IsARectangleWhoseBaseDipsIntoTheHill) {
    const Profile profile = cut(face_angle, 20, 30, 160);
    SourceSpec spec = box(6, 3);
    spec.type = SourceType::a;
    spec.base_angle = base_angle;
    const Source s = derive_source(profile, spec);
    EXPECT_NEAR(s.area, 18, 1e-14);
    EXPECT_EQ(s.exit_point, Vec2(0, 0));
    EXPECT_LT((s.head - 6 * Vec2(-std::cos(base_angle), std::sin(base_angle))).norm(), 1e-14);
    EXPECT_NEAR(s.front_area, 18 - 6 * 6 * std::tan(radians(20)) / 2, 1e-12);
    EXPECT_NEAR(s.drop_height, 6 * std::sin(base_angle), 1e-14);

    // The hill above the base has gone: a vertical scarp stands over the head.
    expect_bed_is_a_ground(s, profile);
    // The head is in front of the crest edge, so that a triangle between face, base and scarp is missing.
    ASSERT_LT(-s.head.x(), 20 / std::tan(face_angle));
    const double missing = s.head.x() * s.head.x() * (std::tan(face_angle) - std::tan(base_angle)) / 2;
    EXPECT_NEAR(area_below(profile.ground) - area_below(s.bed), missing, 1e-10);
}

TEST(TypeA, DropHeightIsToTheHeadOrToP) {
    const Profile profile = cut(face_angle, 20, 30, 160);
    SourceSpec spec = box(6, 3);
    spec.type = SourceType::a;
    spec.base_angle = base_angle;
    spec.drop_height = 10;
    EXPECT_NEAR(derive_source(profile, spec).head.y(), 10, 1e-13);
    spec.datum = DropDatum::base;
    EXPECT_NEAR(derive_source(profile, spec).exit_point.y(), 10, 1e-13);
}

TEST(TypeA, RefusesABaseOutsideTheHillside) {
    const Profile profile = cut(face_angle, 20, 30, 160);
    SourceSpec spec = box(6, 3);
    spec.type = SourceType::a;
    EXPECT_PRED2(contains, error_of(profile, spec), "source.base_angle_deg: is missing");
    spec.base_angle = radians(71);
    EXPECT_PRED2(contains, error_of(profile, spec), "is not flatter than the face; give less than 70");
    spec.base_angle = base_angle;
    spec.drop_height = 1;
    EXPECT_PRED2(contains, error_of(profile, spec),
                 "puts the lower end of the source 2.44146 m below the toe");
    spec = box(60, 1);
    spec.type = SourceType::a;
    spec.base_angle = radians(10);
    EXPECT_PRED2(contains, error_of(profile, spec), "beyond the uphill end of the section");
    spec = box(20, 1);
    spec.type = SourceType::a;
    spec.base_angle = base_angle;
    spec.datum = DropDatum::base;
    spec.drop_height = 15;  // the base rises above the level crest surface
    EXPECT_PRED2(contains, error_of(profile, spec), "lets the base come out of the hillside");
}

}  // namespace
}  // namespace runout
