#include "source/source.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/input_error.h"
#include "profile/profile.h"
#include "source/area_search.h"
#include "source/ground_walk.h"
#include "source/polygons.h"

using namespace runout;

namespace {

constexpr double face_angle = radians(70);
constexpr double base_angle = radians(35);
constexpr double scarp_angle = radians(80);

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::string error_of(const Profile& profile, const SourceSpec& spec) {
    try {
        derive_source(profile, spec);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

Profile profile_of(const std::vector<Vec2>& points) {
    return make_profile(points, {}, "section.csv", {});
}

/// A straight face between level ground.
Profile cut(double angle, double height, double back, double out) {
    const double width = height / std::tan(angle);
    return profile_of({{-back - width, height}, {-width, height}, {0, 0}, {out, 0}});
}

Profile shipped(const std::string& name) {
    return read_profile_csv(RUNOUT_SOURCE_DIR "/profiles/" + name, {});
}

SourceSpec type_b() {
    SourceSpec spec;
    spec.type = SourceType::b;
    spec.base_angle = base_angle;
    spec.scarp_angle = scarp_angle;
    return spec;
}

SourceSpec fig15() {
    SourceSpec spec = type_b();
    spec.type = SourceType::c;
    spec.height = 0.15;
    spec.area = 0.0043;
    return spec;
}

SourceSpec box(double length, double thickness) {
    SourceSpec spec;
    spec.type = SourceType::rectangle;
    spec.length = length;
    spec.thickness = thickness;
    return spec;
}

SourceSpec free_shape(SourceType type, const std::vector<Vec2>& points) {
    SourceSpec spec;
    spec.type = type;
    spec.points = points;
    return spec;
}

/// Triangle on a face of angle a whose third side is `side` long, with angles a - base and scarp - a beside
/// it.
double triangle_area(double side, double base, double face, double scarp) {
    return side * side / 2 * std::sin(face - base) * std::sin(scarp - face) / std::sin(scarp - base);
}

double area_below(const Polyline& line) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        sum += (line[i + 1].x() - line[i].x()) * (line[i + 1].y() + line[i].y()) / 2;
    return sum;
}

double signed_area(const Polygon& p) {
    double twice = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Vec2& a = p[i];
        const Vec2& b = p[(i + 1) % p.size()];
        twice += a.x() * b.y() - b.x() * a.y();
    }
    return twice / 2;
}

double distance_to_corner(const Polygon& outline, const Vec2& p) {
    double nearest_corner = 1e300;
    for (const Vec2& q : outline) nearest_corner = std::min(nearest_corner, (p - q).norm());
    return nearest_corner;
}

void expect_bed_is_a_ground(const Source& source, const Profile& profile) {
    EXPECT_EQ(source.bed.front(), profile.ground.front());
    EXPECT_EQ(source.bed.back(), profile.ground.back());
    for (std::size_t i = 0; i + 1 < source.bed.size(); ++i) {
        EXPECT_LE(source.bed[i].x(), source.bed[i + 1].x());
        EXPECT_NE(source.bed[i], source.bed[i + 1]);
    }
}

/// The mass is ground: what it holds is missing in the bed.
void expect_cut_from_ground(const Source& source, const Profile& profile) {
    expect_bed_is_a_ground(source, profile);
    const double missing = area_below(profile.ground) - area_below(source.bed);
    EXPECT_NEAR(missing, source.area, 1e-12 * std::abs(area_below(profile.ground)));
    EXPECT_NEAR(signed_area(source.outline), source.area, 1e-12 * std::max(1.0, source.area));
}

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
    EXPECT_EQ(error_of(profile, spec), "no error");
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

// ---- polygon and slip surface

TEST(FreePolygon, ColumnAtAWallAndOnAFlatBed) {
    const std::vector<Vec2> column{{0, 0}, {0.2, 0}, {0.2, 0.1}, {0, 0.1}};
    for (const auto& ground :
         {std::vector<Vec2>{{0, 0.15}, {0, 0}, {1, 0}}, std::vector<Vec2>{{0, 0}, {1, 0}}}) {
        const Profile profile = profile_of(ground);
        const Source s = derive_source(profile, free_shape(SourceType::polygon, column));
        EXPECT_EQ(s.outline, column);
        EXPECT_NEAR(s.area, 0.02, 1e-17);
        EXPECT_EQ(s.bed, profile.ground);
        EXPECT_EQ(s.exit_point, Vec2(0.2, 0));
        EXPECT_EQ(s.head, Vec2(0, 0.1));
        EXPECT_EQ(s.drop_height, 0.1);
        EXPECT_NEAR(s.front_area, 0.1 * 0.1 / std::tan(radians(55)) / 2, 1e-16);
    }
}

TEST(FreePolygon, ClockwiseOrClosedIsTheSame) {
    const Profile profile = shipped("toe-wall-column.csv");
    const Source a =
        derive_source(profile, free_shape(SourceType::polygon, {{0, 0}, {0.2, 0}, {0.2, 0.1}, {0, 0.1}}));
    const Source b = derive_source(
        profile, free_shape(SourceType::polygon, {{0, 0.1}, {0.2, 0.1}, {0.2, 0}, {0, 0}, {0, 0.1}}));
    EXPECT_EQ(a.outline, b.outline);
}

TEST(FreePolygon, BoxWithRoundedCornersTakesNoSliverFromTheFace) {
    // A box on the 45 deg face, its corners rounded to a tenth of a millimetre.
    const Profile profile = shipped("box-45.csv");
    const Source s = derive_source(
        profile, free_shape(SourceType::polygon,
                            {{0.0, 0.4}, {0.07071, 0.32929}, {0.10607, 0.36464}, {0.03536, 0.43535}}));
    EXPECT_EQ(s.bed, profile.ground);
    EXPECT_EQ(s.head, profile.to_local({0.0, 0.4}));
    EXPECT_EQ(s.exit_point, profile.to_local({0.07071, 0.32929}));
}

TEST(FreePolygon, EmbeddedPartIsCutFromTheBed) {
    const Profile profile = cut(face_angle, 0.4, 0.3, 1.5);
    SourceSpec by_angles = type_b();
    by_angles.height = 0.15;
    const Source b = derive_source(profile, by_angles);
    std::vector<Vec2> corners;
    for (const Vec2& p : b.outline) corners.push_back(profile.to_section(p));
    const Source s = derive_source(profile, free_shape(SourceType::polygon, corners));
    EXPECT_NEAR(s.area, b.area, 1e-12 * b.area);
    EXPECT_NEAR(s.front_area, b.front_area, 1e-12 * b.area);
    EXPECT_LT((s.head - b.head).norm(), 1e-14);
    EXPECT_LT((s.exit_point - b.exit_point).norm(), 1e-14);
    expect_bed_is_a_ground(s, profile);
    EXPECT_NEAR(area_below(s.bed), area_below(b.bed), 1e-13);
    ASSERT_EQ(s.bed.size(), b.bed.size());  // nothing left of the last digits
}

TEST(FreePolygon, FloatingMassLeavesTheGroundAsItIs) {
    const Profile profile = shipped("box-45.csv");
    const Source s = derive_source(
        profile, free_shape(SourceType::polygon, {{0.5, 0.5}, {0.6, 0.5}, {0.6, 0.6}, {0.5, 0.6}}));
    EXPECT_EQ(s.bed, profile.ground);
    EXPECT_NEAR(s.head.y(), 0.6, 1e-15);
    EXPECT_LT((s.exit_point - profile.to_local({0.6, 0.5})).norm(), 1e-15);
}

TEST(FreePolygon, RefusesWhatIsNoSource) {
    const Profile profile = shipped("box-45.csv");
    const auto error = [&](const std::vector<Vec2>& points) {
        return error_of(profile, free_shape(SourceType::polygon, points));
    };
    EXPECT_PRED2(contains, error({}), "source.points: has 0 points");
    EXPECT_PRED2(contains, error({{0, 0}, {1, 1}}),
                 "source.points: has 2 points; a polygon needs at least 3");
    EXPECT_PRED2(contains, error({{0, 0.5}, {0.2, 0.7}, {0.2, 0.5}, {0, 0.7}}), "is not a simple polygon");
    EXPECT_PRED2(contains, error({{0, 0.5}, {0.1, 0.6}, {0.2, 0.7}}), "is not a simple polygon");
    EXPECT_PRED2(contains, error({{-0.1, 0.5}, {0.2, 0.5}, {0.2, 0.7}}), "leaves the section at [-0.1, 0.5]");
    EXPECT_PRED2(contains, error({{0, 0.5}, {NAN, 0.5}, {0.2, 0.7}}), "not finite");
    EXPECT_PRED2(contains, error({{1, -0.3}, {1.2, -0.3}, {1.2, -0.1}}), "lies under the ground");
}

TEST(SlipSurface, CutsTheGroundAboveIt) {
    const Profile profile = cut(face_angle, 0.4, 0.3, 1.5);
    SourceSpec by_angles = type_b();
    by_angles.height = 0.15;
    const Source b = derive_source(profile, by_angles);
    Vec2 foot;
    for (const Vec2& p : b.outline)
        if (p != b.head && p != b.exit_point) foot = p;
    const std::vector<Vec2> line{profile.to_section(b.head), profile.to_section(foot),
                                 profile.to_section(b.exit_point)};
    const Source s = derive_source(profile, free_shape(SourceType::slip_surface, line));
    EXPECT_NEAR(s.area, b.area, 1e-12 * b.area);
    EXPECT_LT((s.head - b.head).norm(), 1e-14);
    EXPECT_LT((s.exit_point - b.exit_point).norm(), 1e-14);
    EXPECT_EQ(s.outline.size(), 3u);
    expect_cut_from_ground(s, profile);
    const Source reversed =
        derive_source(profile, free_shape(SourceType::slip_surface, {line[2], line[1], line[0]}));
    EXPECT_EQ(reversed.outline, s.outline);
}

TEST(SlipSurface, DeepSeatedThroughCrestAndRunOutSurface) {
    const Profile profile = cut(radians(60), 20, 30, 160);
    const Source s = derive_source(
        profile, free_shape(SourceType::slip_surface, {{-25, 25}, {-22, 8}, {-10, -3}, {0, -4}, {12, 2}}));
    EXPECT_DOUBLE_EQ(s.head.y(), 20);
    EXPECT_EQ(s.exit_point.y(), 0);
    EXPECT_NEAR(s.exit_point.x(), 8, 1e-12);
    expect_cut_from_ground(s, profile);
}

TEST(SlipSurface, EndsMissedByTheRoundingOfADrawingAreMoved) {
    const Profile profile = cut(radians(60), 20, 30, 160);
    const Source s = derive_source(
        profile, free_shape(SourceType::slip_surface, {{-15, 19.999}, {-10, 5}, {-0.003, 0.0}}));
    EXPECT_NEAR(s.head.y(), 20, 1e-12);
    expect_cut_from_ground(s, profile);
    EXPECT_LE(s.outline.size(), 5u);
}

TEST(SlipSurface, RefusesLinesThatCutOffNoneOrSeveral) {
    const Profile profile = cut(radians(60), 20, 30, 160);
    const auto error = [&](const std::vector<Vec2>& points) {
        return error_of(profile, free_shape(SourceType::slip_surface, points));
    };
    EXPECT_PRED2(contains, error({{-20, 20}}), "has 1 points; a slip_surface needs at least 2");
    EXPECT_PRED2(contains, error({{-20, 25}, {0, 25}}), "cuts off 0 pieces");
    EXPECT_PRED2(contains, error({{-20, 20}, {-18, 15}, {-16, 21}, {-14, 15}, {0, 0}}), "cuts off 2 pieces");
    EXPECT_PRED2(contains, error({{-20, 18}, {-10, 5}, {0, 0}}),
                 "ends inside the ground at [-20, 18]; go on to the surface, which is at [-20, 20]");
    EXPECT_PRED2(contains, error({{-20, 20}, {-10, 5}, {-12, 4}, {0, 0}}), "turns back at [-10, 5]");
    EXPECT_PRED2(contains, error({{-20, 20}, {-20, 5}, {-20, 12}, {0, 0}}), "doubles back");
    EXPECT_PRED2(contains, error({{-20, 20}, {-16, 20 - 1e-9}, {-12, 20}}), "a film of ground");
}

// ---- all types

std::vector<SourceSpec> one_of_each() {
    std::vector<SourceSpec> specs{box(3, 1), box(6, 3), type_b(), fig15()};
    specs[1].type = SourceType::a;
    specs[1].base_angle = base_angle;
    specs[2].area = 8;
    specs[3].height = SourceSpec::unset;
    specs[3].area = 100;
    return specs;
}

TEST(AnySource, MirroredSectionGivesTheSameSourceToTheBit) {
    const std::vector<Vec2> section{{0, 20.5}, {30.3, 20.1}, {38.7, 0.7}, {150.1, 0.3}};
    std::vector<Vec2> mirrored;
    for (auto p = section.rbegin(); p != section.rend(); ++p) mirrored.emplace_back(-p->x(), p->y());
    for (const SourceSpec& spec : one_of_each()) {
        SCOPED_TRACE(to_string(spec.type));
        const Source a = derive_source(profile_of(section), spec);
        const Source b = derive_source(profile_of(mirrored), spec);
        EXPECT_EQ(a.outline, b.outline);
        EXPECT_EQ(a.bed, b.bed);
        EXPECT_EQ(a.area, b.area);
        EXPECT_EQ(a.front_area, b.front_area);
    }
}

TEST(AnySource, MapGridChainagesGiveTheSameSource) {
    const std::vector<Vec2> section{{0, 20.5}, {30.3, 20.1}, {38.7, 0.7}, {150.1, 0.3}};
    std::vector<Vec2> far = section;
    for (Vec2& p : far) p.x() += 8.3e5;
    std::vector<SourceSpec> specs = one_of_each();
    specs.push_back(free_shape(SourceType::slip_surface, {{25, 20.3}, {30, 8}, {38.7, 0.7}}));
    for (const SourceSpec& spec : specs) {
        SCOPED_TRACE(to_string(spec.type));
        SourceSpec shifted = spec;
        for (Vec2& p : shifted.points) p.x() += 8.3e5;
        const Source a = derive_source(profile_of(section), spec);
        const Source b = derive_source(profile_of(far), shifted);
        ASSERT_EQ(a.outline.size(), b.outline.size());
        for (std::size_t i = 0; i < a.outline.size(); ++i)
            EXPECT_LT((a.outline[i] - b.outline[i]).norm(), 1e-9);
        ASSERT_EQ(a.bed.size(), b.bed.size());
        EXPECT_NEAR(a.area, b.area, 1e-9 * std::max(1.0, a.area));
        EXPECT_NEAR(a.front_area / a.area, b.front_area / b.area, 1e-9);
    }
}

TEST(AnySource, EveryShippedCutCarriesItsTypes) {
    for (const std::string name :
         {"cut-60.csv", "cut-70.csv", "cut-wall.csv", "cut-berm.csv", "cut-map-grid.csv"})
        for (const SourceSpec& spec : one_of_each()) {
            SCOPED_TRACE(name + " " + to_string(spec.type));
            const Profile profile = shipped(name);
            const Source s = derive_source(profile, spec);
            EXPECT_GT(s.front_area, 0);
            EXPECT_LE(s.front_area, s.area);
            EXPECT_GT(signed_area(s.outline), 0);
            expect_bed_is_a_ground(s, profile);
        }
}

TEST(AnySource, RefusesKeysItDoesNotUseAndValuesOutOfRange) {
    const Profile profile = cut(face_angle, 0.4, 0.3, 1.5);
    SourceSpec spec = type_b();
    spec.length = 0.1;
    EXPECT_PRED2(contains, error_of(profile, spec),
                 "source.length_m = 0.1: is not used by a source of type B; leave it out; this type takes "
                 "source.base_angle_deg, "
                 "source.scarp_angle_deg, source.area_m2, source.height_m, source.drop_height_m");
    spec = type_b();
    spec.points = {{0, 0}};
    EXPECT_PRED2(contains, error_of(profile, spec), "source.points: is not used by a source of type B");
    spec = free_shape(SourceType::polygon, {{0, 0.5}, {0.2, 0.5}, {0.2, 0.7}});
    spec.drop_height = 0.1;
    EXPECT_PRED2(contains, error_of(profile, spec),
                 "source.drop_height_m = 0.1: is not used by a source of type polygon");
    spec = type_b();
    spec.scarp_angle = radians(95);
    EXPECT_PRED2(contains, error_of(profile, spec),
                 "source.scarp_angle_deg = 95: is out of range; give degrees from 0 to 90");
    spec.scarp_angle = radians(30);
    EXPECT_PRED2(contains, error_of(profile, spec),
                 "source.scarp_angle_deg = 30: is not steeper than the base");
    spec.scarp_angle = SourceSpec::unset;
    EXPECT_PRED2(contains, error_of(profile, spec),
                 "source.scarp_angle_deg: is missing for a source of type B");
    spec = type_b();
    spec.area = 0;
    EXPECT_PRED2(contains, error_of(profile, spec), "source.area_m2 = 0: is out of range");
    spec.area = INFINITY;
    EXPECT_PRED2(contains, error_of(profile, spec), "source.area_m2 = inf: is out of range");
    spec = type_b();
    spec.drop_height = -1;
    EXPECT_PRED2(contains, error_of(profile, spec), "source.drop_height_m = -1: is out of range");
    spec = type_b();
    spec.discontinuity_angle = 0;
    EXPECT_PRED2(contains, error_of(profile, spec), "source.discontinuity_angle_deg = 0: is out of range");
    EXPECT_PRED2(contains, error_of(profile_of({{0, 0}, {1, 0}}), type_b()),
                 "B needs a face, and the section section.csv has none");
}

TEST(AnySource, ErrorsNameFileAndLineWhenTheyAreKnown) {
    SourceSpec spec = type_b();
    spec.area = 1;
    spec.places["source.area_m2"] = {"case.toml", 7, "", "1.0"};
    EXPECT_PRED2(contains, error_of(cut(face_angle, 0.4, 0.3, 1.5), spec),
                 "case.toml, line 7: source.area_m2 = 1.0: puts");
}

TEST(AnySource, DiscontinuityMayBeVertical) {
    SourceSpec spec = fig15();
    spec.discontinuity_angle = radians(90);
    EXPECT_EQ(derive_source(shipped("fig15.csv"), spec).front_area, 0);
}

// ---- the exact polygons and the ground

TEST(Region, BoxOnARisingFaceTouchesItWithoutAGap) {
    const Polyline ground{{-1.1, 0.7}, {0, 0}, {3, 0}};
    const Region box_region = box_on_ground(ground, {0, 0.9}, 1.0 / 3, 0.1);
    EXPECT_EQ(box_region.bed_in(ground), ground);
    const double length2 = 1.1 * 1.1 + 0.7 * 0.7;
    EXPECT_NEAR(box_region.area(), length2 / 30, 1e-16);
    EXPECT_NEAR(box_region.area_above({0, -1}, radians(1)), length2 / 30, 1e-16);
    EXPECT_EQ(box_region.area_above({0, 9}, radians(1)), 0);
}

TEST(Region, ConcaveMassTakesTheGroundAboveItsArms) {
    // A hook that reaches under a piece of ground: no overhang may stay.
    const Polyline ground{{0, 10}, {10, 10}, {10, 0}, {20, 0}};
    const auto hook = simple_polygon({{4, 4}, {10, 4}, {10, 5}, {5, 5}, {5, 10}, {4, 10}});
    ASSERT_TRUE(hook);
    const Polyline expected{{0, 10}, {4, 10}, {4, 4}, {10, 4}, {10, 0}, {20, 0}};
    EXPECT_EQ(hook->bed_in(ground), expected);
}

TEST(AreaSearch, FindsTheLastDigitInFewSteps) {
    int calls = 0;
    const auto area = [&](const GroundPoint& p) {
        ++calls;
        const double s = static_cast<double>(p.segment) + p.fraction;
        return 0.3 * s * s + 0.1 * s;
    };
    const std::vector<Stretch> way{{0, 0, 1}, {1, 0, 1}, {2, 0, 1}, {3, 0, 1}};
    const auto found = point_with_area(way, area, 2.0);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->segment, 2u);
    EXPECT_NEAR(area(*found), 2.0, 2e-14);
    EXPECT_LT(calls, 20);
    EXPECT_FALSE(point_with_area(way, area, 5.21));
    EXPECT_FALSE(point_with_area({}, area, 1));
}

TEST(GroundWalk, GoesAlongTheGroundInBothDirections) {
    const Polyline ground{{0, 4}, {1, 4}, {2, 2}, {2, 0}, {4, 0}};
    const auto up = walk(at_vertex(ground, 4), {1, 0.5});
    ASSERT_EQ(up.size(), 3u);
    EXPECT_EQ(up[0].segment, 3u);
    EXPECT_EQ(up[2].to, 0.5);
    EXPECT_EQ(walk({1, 0.5}, at_vertex(ground, 4)).size(), 3u);
    EXPECT_TRUE(walk({1, 0.5}, {1, 0.5}).empty());
    const auto on_wall = first_at_elevation(ground, up, 0.5);
    ASSERT_TRUE(on_wall);
    EXPECT_EQ(position(ground, *on_wall), Vec2(2, 0.5));
    EXPECT_FALSE(first_at_elevation(ground, up, 3.5));
    EXPECT_EQ(elevation_at(ground, 2), 2);
    EXPECT_EQ(elevation_at(ground, 1.5), 3);
    EXPECT_EQ(without_needless_points({{0, 0}, {1, 1e-14}, {1, 0}, {2, 0}, {3, 1}}, 1e-12).size(), 3u);
}

}  // namespace
