// Masses drawn freely, and what holds for sources of any type.

#include <set>

#include "source/source_types.h"
#include "source/spec_check.h"
#include "source_fixture.h"

namespace runout {
namespace {

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
        for (SectionPoint& p : shifted.points) p.chainage = Chainage(p.chainage.m + 8.3e5);
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

// ---- the table of types

/// The compiler complains here when the enumeration has a value that is not named, so that the test below can
/// ask for the row of each.
bool is_enumerated(SourceType type) {
    switch (type) {
        case SourceType::rectangle:
        case SourceType::a:
        case SourceType::b:
        case SourceType::c:
        case SourceType::polygon:
        case SourceType::slip_surface:
            return true;
    }
    return false;
}

TEST(SourceTypes, EachValueHasExactlyOneRow) {
    std::set<std::string_view> names;
    for (int value = -10; value < 100; ++value) {
        const auto type = static_cast<SourceType>(value);
        EXPECT_EQ(std::ranges::count(source_types(), type, &SourceTypeRow::type), is_enumerated(type) ? 1 : 0)
            << value;
    }
    for (const SourceTypeRow& row : source_types()) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_EQ(source_type_named(row.name), row.type);
        EXPECT_EQ(to_string(row.type), row.name);
        EXPECT_NE(row.keys.empty(), row.fewest_points == 0) << row.name << " has sizes, or points";
        EXPECT_TRUE(row.derive != nullptr);
    }
}

TEST(SourceTypes, AValueOutsideTheTableIsAnErrorAndNoSlipSurface) {
    const Profile profile = cut(face_angle, 0.4, 0.3, 1.5);
    const auto unknown = static_cast<SourceType>(source_types().size());
    for (SourceSpec spec :
         {type_b(), SourceSpec{}, free_shape(SourceType::polygon, {{0, 0}, {0.1, 0}, {0, 0.1}})}) {
        spec.type = unknown;
        const std::string said = error_of(profile, spec);
        EXPECT_TRUE(said.starts_with("source.type = ")) << said;
        EXPECT_PRED2(contains, said,
                     "is not a known type; known are rectangle, A, B, C, polygon, slip_surface");
    }
    EXPECT_PRED2(contains, input_error([&] { (void)to_string(unknown); }), "is not a known type");
    EXPECT_PRED2(contains, input_error([] { source_type_named("slip surface"); }),
                 "source.type = slip surface: is not a known type");
}

TEST(SourceTypes, SayWhichKeysTheyUse) {
    using enum SourceType;
    EXPECT_EQ(types_using("source.scarp_angle_deg"), (std::vector{b, c}));
    EXPECT_EQ(types_using("source.length_m"), (std::vector{rectangle, a}));
    EXPECT_EQ(types_using("source.points"), (std::vector{polygon, slip_surface}));
    EXPECT_TRUE(types_using("source.type").empty());
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

}  // namespace
}  // namespace runout
