// The face of a cut is found by its scale: kerbs, steps, ledges, ditches and noise of a survey do not move
// it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/units.h"
#include "face_shapes.h"
#include "profile/profile.h"
#include "profile/read_section_table.h"
#include "said.h"

using namespace runout;

namespace {

constexpr int variants = 50;

Profile profile_of(const std::vector<Vec2>& points, const ProfileOptions& options = {}) {
    return make_profile({points, {}, "section.csv"}, options);
}

double crest_chainage(const Profile& p) {
    return p.to_section(p.ground[p.crest]).x();
}

double uniform(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// Elevation of a section at x; the lower one at a vertical face.
double elevation(const std::vector<Vec2>& points, double x) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec2& a = points[i - 1];
        const Vec2& b = points[i];
        if (x >= a.x() && x < b.x()) return a.y() + (b.y() - a.y()) * (x - a.x()) / (b.x() - a.x());
    }
    return points.back().y();
}

/// The section with its ground raised by `rise` beyond x, over a run of `run`.
std::vector<Vec2> with_step(const std::vector<Vec2>& points, double x, double run, double rise) {
    std::vector<Vec2> stepped;
    for (const Vec2& p : points)
        if (p.x() < x) stepped.push_back(p);
    stepped.emplace_back(x, elevation(points, x));
    stepped.emplace_back(x + run, elevation(points, x + run) + rise);
    for (const Vec2& p : points)
        if (p.x() > x + run) stepped.emplace_back(p.x(), p.y() + rise);
    return stepped;
}

double highest_batter(const FaceShape& shape) {
    double highest = 0;
    for (std::size_t i = shape.crest; i < shape.toe; ++i)
        highest = std::max(highest, shape.points[i].y() - shape.points[i + 1].y());
    return highest;
}

/// The section with its ground raised by `rise` uphill of x.
std::vector<Vec2> with_ledge(const std::vector<Vec2>& points, double x, double rise) {
    std::vector<Vec2> stepped;
    for (const Vec2& p : points)
        if (p.x() < x) stepped.emplace_back(p.x(), p.y() + rise);
    stepped.emplace_back(x, elevation(points, x) + rise);
    stepped.emplace_back(x, elevation(points, x));
    for (const Vec2& p : points)
        if (p.x() > x) stepped.push_back(p);
    return stepped;
}

/// Puts in the two points of each vertical face, which a surveyor takes.
void insert_walls(std::vector<Vec2>& survey, const std::vector<Vec2>& points) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (points[i].x() != points[i - 1].x()) continue;
        const auto at =
            std::ranges::lower_bound(survey, points[i].x(), {}, [](const Vec2& p) { return p.x(); });
        survey.insert(at, {points[i - 1], points[i]});
    }
}

std::vector<Vec2> mirrored(const std::vector<Vec2>& points) {
    std::vector<Vec2> other;
    for (auto p = points.rbegin(); p != points.rend(); ++p) other.emplace_back(-p->x(), p->y());
    return other;
}

class Shapes : public testing::Test {
  protected:
    std::vector<FaceShape> shapes = face_shapes();
};

TEST_F(Shapes, AreMoreThanForty) {
    EXPECT_GE(shapes.size(), 40u);
}

TEST_F(Shapes, HaveTheirToeAndCrestFound) {
    for (const FaceShape& shape : shapes) {
        const Profile p = profile_of(shape.points);
        EXPECT_EQ(p.toe_chainage_m, shape.points[shape.toe].x()) << shape.name;
        EXPECT_NEAR(crest_chainage(p), shape.points[shape.crest].x(), 1e-12) << shape.name;
        EXPECT_EQ(p.doubts, std::vector<std::string>{}) << shape.name;
        EXPECT_FALSE(p.toe_given);
        EXPECT_FALSE(p.crest_given);
    }
}

TEST_F(Shapes, KeepTheirToeWithAStepBeyondIt) {
    std::mt19937 random(1);
    for (const FaceShape& shape : shapes) {
        const Profile clean = profile_of(shape.points);
        const double toe = shape.points[shape.toe].x();
        const double relief = shape.points[shape.crest].y() - shape.points[shape.toe].y();
        for (int i = 0; i < variants; ++i) {
            const double x = uniform(random, toe + 0.1 * relief, shape.points.back().x() - 1);
            const double height = uniform(random, 0, 0.05 * relief) * (i % 2 == 0 ? 1 : -1);
            const double run = i % 3 == 0 ? 0 : uniform(random, 0, 0.3);
            const Profile p = profile_of(with_step(shape.points, x, run, height));
            EXPECT_EQ(p.toe_chainage_m, clean.toe_chainage_m) << shape.name << " " << x << " " << height;
            EXPECT_EQ(crest_chainage(p), crest_chainage(clean)) << shape.name << " " << x << " " << height;
        }
    }
}

TEST_F(Shapes, KeepTheirToeWithADrainBeyondIt) {
    std::mt19937 random(2);
    for (const FaceShape& shape : shapes) {
        const Profile clean = profile_of(shape.points);
        const double toe = shape.points[shape.toe].x();
        const double relief = shape.points[shape.crest].y() - shape.points[shape.toe].y();
        for (int i = 0; i < variants; ++i) {
            const double x = uniform(random, toe + 0.02 * relief, toe + 2 * relief);
            const double depth = uniform(random, 0, 0.05 * relief);
            const double width = uniform(random, 0.01, 0.05) * relief;
            const auto drained = with_step(with_step(shape.points, x, 0, -depth), x + width, 0, depth);
            const Profile p = profile_of(drained);
            EXPECT_EQ(p.toe_chainage_m, clean.toe_chainage_m) << shape.name << " " << x << " " << depth;
            EXPECT_EQ(crest_chainage(p), crest_chainage(clean)) << shape.name << " " << x << " " << depth;
        }
    }
}

TEST_F(Shapes, KeepTheirCrestWithALedgeAboveIt) {
    std::mt19937 random(3);
    for (const FaceShape& shape : shapes) {
        const double crest = shape.points[shape.crest].x();
        const double relief = shape.points[shape.crest].y() - shape.points[shape.toe].y();
        const double room = crest - 0.1 * relief - shape.points.front().x();
        if (room < 1) continue;
        for (int i = 0; i < variants; ++i) {
            const double x = shape.points.front().x() + uniform(random, 0.01, room);
            const Profile p = profile_of(with_ledge(shape.points, x, uniform(random, 0, 0.05 * relief)));
            EXPECT_EQ(p.toe_chainage_m, shape.points[shape.toe].x()) << shape.name << " " << x;
            EXPECT_NEAR(crest_chainage(p), crest, 1e-12) << shape.name << " " << x;
        }
    }
}

TEST_F(Shapes, KeepTheirToeWithALesserDescentBelow) {
    std::mt19937 random(4);
    for (const FaceShape& shape : shapes) {
        const double toe = shape.points[shape.toe].x();
        const double relief = shape.points[shape.crest].y() - shape.points[shape.toe].y();
        for (int i = 0; i < variants; ++i) {
            // From half of a batter upwards it may be one more bench.
            const double most = std::min(0.2 * relief, 0.499 * highest_batter(shape));
            const double height = uniform(random, 0.25 * most, most);
            const double x = uniform(random, toe + 0.1 * relief, toe + (i % 2 == 0 ? 0.2 : 2) * relief);
            const double run = height / std::tan(radians(uniform(random, 25, 90)));
            const Profile p = profile_of(with_step(shape.points, x, run, -height));
            EXPECT_EQ(p.toe_chainage_m, toe) << shape.name << " " << x << " " << height << " " << run;
            EXPECT_NEAR(crest_chainage(p), shape.points[shape.crest].x(), 1e-12) << shape.name << " " << x;
        }
    }
}

TEST_F(Shapes, KeepToeAndAngleInTheNoiseOfADenseSurvey) {
    std::mt19937 random(5);
    for (const FaceShape& shape : shapes) {
        const Profile clean = profile_of(shape.points);
        for (int i = 0; i < variants; ++i) {
            std::vector<Vec2> survey;
            const double first = shape.points.front().x() + uniform(random, 0, 0.5);
            for (double x = first; x < shape.points.back().x(); x += 0.5)
                survey.emplace_back(x, elevation(shape.points, x) + uniform(random, -0.05, 0.05));
            insert_walls(survey, shape.points);
            const Profile p = profile_of(survey);
            EXPECT_NEAR(p.toe_chainage_m, clean.toe_chainage_m, 1) << shape.name << " " << i;
            // A corner lies up to a quarter of a metre from the points: too much for the angle of a face of 6
            // m.
            if (shape.name == "low") continue;
            EXPECT_NEAR(degrees(p.slope_angle), degrees(clean.slope_angle), 1) << shape.name << " " << i;
        }
    }
}

TEST_F(Shapes, AreTheSameWithMorePointsOnTheirStraightLines) {
    std::mt19937 random(6);
    for (const FaceShape& shape : shapes) {
        const Profile clean = profile_of(shape.points);
        for (int i = 0; i < variants; ++i) {
            std::vector<Vec2> more;
            for (std::size_t k = 0; k < shape.points.size(); ++k) {
                more.push_back(shape.points[k]);
                if (k + 1 == shape.points.size() || shape.points[k].x() == shape.points[k + 1].x()) continue;
                std::vector<double> shares;
                for (int n = uniform(random, 0, 1) < 0.5 ? 0 : i; n > 0; --n)
                    shares.push_back(uniform(random, 0.001, 0.999));
                std::ranges::sort(shares);
                for (const double share : shares)
                    more.push_back(shape.points[k] + share * (shape.points[k + 1] - shape.points[k]));
            }
            const Profile p = profile_of(more);
            EXPECT_NEAR(p.toe_chainage_m, clean.toe_chainage_m, 1e-9) << shape.name << " " << i;
            EXPECT_NEAR(crest_chainage(p), crest_chainage(clean), 1e-9) << shape.name << " " << i;
        }
    }
}

TEST_F(Shapes, AreTheSameMirroredToTheBit) {
    for (const FaceShape& shape : shapes) {
        const Profile a = profile_of(shape.points);
        const Profile b = profile_of(mirrored(shape.points));
        EXPECT_EQ(a.ground, b.ground) << shape.name;
        EXPECT_EQ(a.toe, b.toe);
        EXPECT_EQ(a.crest, b.crest);
        EXPECT_FALSE(b.descends_with_chainage);
    }
}

TEST_F(Shapes, HaveTheSameCrestWhenTheirToeIsGivenAndTheOtherWayRound) {
    std::mt19937 random(7);
    for (const FaceShape& shape : shapes)
        for (int i = 0; i < variants; ++i) {
            std::vector<Vec2> points = shape.points;
            if (i > 0) {  // a dense survey
                points.clear();
                const double first = shape.points.front().x() + uniform(random, 0, 0.5);
                for (double x = first; x < shape.points.back().x(); x += 0.5)
                    points.emplace_back(x, elevation(shape.points, x) + uniform(random, -0.05, 0.05));
            }
            const Profile found = profile_of(points);
            ProfileOptions toe;
            toe.toe_chainage = Chainage(found.toe_chainage_m);
            EXPECT_NEAR(crest_chainage(profile_of(points, toe)), crest_chainage(found), 0.05) << shape.name;
            ProfileOptions crest;
            crest.crest_chainage = Chainage(crest_chainage(found));
            EXPECT_NEAR(profile_of(points, crest).toe_chainage_m, found.toe_chainage_m, 0.05) << shape.name;
        }
}

TEST_F(Shapes, AreTheSameOnAMapGrid) {
    for (const FaceShape& shape : shapes) {
        std::vector<Vec2> far = shape.points;
        for (Vec2& p : far) p.x() += 832000;
        const Profile a = profile_of(shape.points);
        const Profile b = profile_of(far);
        EXPECT_EQ(a.toe, b.toe) << shape.name;
        EXPECT_EQ(a.crest, b.crest) << shape.name;
    }
}

// ---- where more than one descent could be meant

bool says(const Profile& p, const std::string& part) {
    return std::ranges::any_of(p.doubts, [&](const std::string& doubt) { return contains(doubt, part); });
}

TEST(ChoiceOfFace, ACutAboveARoadWithAFillBelowIsChosenAndTheFillNamed) {
    const Profile p =
        profile_of({{0, 40}, {20, 38}, {30, 23}, {37, 23}, {37.2, 22.85}, {38, 22.85}, {50, 15}, {120, 14}});
    EXPECT_EQ(p.toe_chainage_m, 30);
    EXPECT_EQ(crest_chainage(p), 20);
    EXPECT_TRUE(says(p, "section.toe_chainage_m = 50"));
}

TEST(ChoiceOfFace, OfTwoCutsOneAboveTheOtherOneIsChosenAndTheOtherNamed) {
    const Profile p = profile_of({{0, 60}, {20, 60}, {29, 45}, {60, 44}, {68, 30}, {160, 30}});
    EXPECT_EQ(p.toe_chainage_m, 29);  // similar ones: the upper, whose run-out is the longer
    EXPECT_TRUE(says(p, "section.toe_chainage_m = 68"));
    ProfileOptions lower;
    lower.toe_chainage = Chainage(68);
    const Profile q = profile_of({{0, 60}, {20, 60}, {29, 45}, {60, 44}, {68, 30}, {160, 30}}, lower);
    EXPECT_EQ(crest_chainage(q), 60);
    EXPECT_TRUE(q.toe_given);
    EXPECT_EQ(q.doubts, std::vector<std::string>{});
}

TEST(ChoiceOfFace, OfTheTwoSidesOfAValleyTheHeavierIsChosenAndTheOtherNamed) {
    const std::vector<Vec2> valley{{0, 45}, {20, 45}, {32, 25}, {60, 24}, {85, 44}, {110, 50}};
    const Profile p = profile_of(valley);
    EXPECT_TRUE(p.descends_with_chainage);  // although the other end is the higher one
    EXPECT_EQ(p.toe_chainage_m, 32);
    EXPECT_TRUE(says(p, "section.toe_chainage_m = 60"));
    ProfileOptions other;
    other.crest_chainage = Chainage(85);
    other.toe_chainage = Chainage(60);
    EXPECT_FALSE(profile_of(valley, other).descends_with_chainage);
}

TEST(ChoiceOfFace, ALongHillsideAboveACutIsNotTheFace) {
    const Profile p = profile_of({{0, 80}, {100, 40}, {110, 22}, {250, 22}});
    EXPECT_EQ(crest_chainage(p), 100);
    EXPECT_EQ(p.toe_chainage_m, 110);
}

TEST(ChoiceOfFace, ABankOfAStreamBelowAnEasySlopeIsNotTheFace) {
    const Profile p =
        profile_of({{0, 30}, {10, 30}, {30, 18}, {45, 17.5}, {45.6, 16.2}, {52, 16.2}, {52.5, 17}, {90, 17}});
    EXPECT_EQ(p.toe_chainage_m, 30);
    EXPECT_EQ(crest_chainage(p), 10);
}

TEST(ChoiceOfFace, AWideBermIsTakenForABermWithAWarning) {
    const Profile p = profile_of({{0, 40}, {20, 40}, {26, 30}, {31.5, 30}, {37.5, 20}, {120, 20}});
    EXPECT_EQ(p.toe_chainage_m, 37.5);
    EXPECT_TRUE(says(p, "from chainage 26 to 31.5 was taken to be a berm"));
    EXPECT_TRUE(says(p, "section.toe_chainage_m = 26"));
}

TEST(ChoiceOfFace, AWallInAnEasierCutIsPartOfIt) {
    const Profile p = profile_of({{0, 30}, {15, 30}, {35, 16}, {35, 10}, {90, 10}});
    EXPECT_EQ(crest_chainage(p), 15);
    EXPECT_EQ(p.toe_elevation_m, 10);
}

TEST(ChoiceOfFace, ADeepValleyFarBelowDoesNotBlurTheFoot) {
    // The relief of the section is four times that of the cut; a kerb lies 2.5 m beyond the toe.
    for (const double face : {25.0, 35.0, 60.0}) {
        const double foot = 30 + 20 / std::tan(radians(face));
        const Profile p = profile_of({{0, 100},
                                      {30, 100},
                                      {foot, 80},
                                      {foot + 2.5, 80},
                                      {foot + 2.5, 79},
                                      {foot + 40, 79},
                                      {foot + 400, 20},
                                      {foot + 500, 20}});
        EXPECT_EQ(p.toe_chainage_m, foot) << face;
        EXPECT_EQ(crest_chainage(p), 30) << face;
    }
}

TEST(ChoiceOfFace, ADeepCrackIsNoFaceAndMovesNoToe) {
    const Profile p = profile_of(
        {{0, 32}, {30, 32}, {41.547, 12}, {46, 12}, {46, -28}, {46.01, -28}, {46.01, 12}, {201, 12}});
    EXPECT_EQ(p.toe_chainage_m, 41.547);
    EXPECT_EQ(crest_chainage(p), 30);
}

TEST(ChoiceOfFace, ATurnedHillIsRefusedWhenBothSidesAreTheSame) {
    EXPECT_PRED2(contains, input_error([] {
                     profile_of({{0, 3}, {5, 8}, {10, 3}});
                 }),
                 "descends neither way");
}

// ---- given chainages

TEST(GivenChainage, MeansTheCornerThatItMissesByAReadingError) {
    ProfileOptions options;
    options.toe_chainage = Chainage(36);
    options.crest_chainage = Chainage(24.97);
    const Profile p = profile_of({{0, 32}, {25, 32}, {35.99, 12}, {150, 12}}, options);
    EXPECT_EQ(p.toe_chainage_m, 35.99);
    EXPECT_EQ(crest_chainage(p), 25);
    EXPECT_EQ(p.ground.size(), 4u);
    options.toe_chainage = Chainage(36.1);
    EXPECT_EQ(profile_of({{0, 32}, {25, 32}, {35.99, 12}, {150, 12}}, options).toe_chainage_m, 36.1);
}

TEST(GivenChainage, OnAModelInTheLaboratoryIsReadMoreClosely) {
    ProfileOptions options;
    options.toe_chainage = Chainage(0.41);
    EXPECT_EQ(profile_of({{0, 0.4}, {0.4, 0}, {1.9, 0}}, options).toe_chainage_m, 0.41);
}

TEST(GivenChainage, FarBeyondTheFootOfTheFaceIsTakenWithAWarning) {
    ProfileOptions options;
    options.toe_chainage = Chainage(55);
    const Profile p = profile_of({{0, 32}, {30, 32}, {41.547, 12}, {201, 12}}, options);
    EXPECT_EQ(p.toe_chainage_m, 55);
    EXPECT_EQ(crest_chainage(p), 30);
    EXPECT_TRUE(says(p, "13.5 m beyond the foot"));
}

// ---- sections as people have them

Profile section_of(const std::string& name) {
    return make_profile(read_section_table(RUNOUT_SOURCE_DIR "/tests/field/" + name + ".csv", {}), {});
}

TEST(FieldSections, HaveTheToeThatASurveyorWouldName) {
    for (const std::string name : {"kerb-beyond", "kerb-near", "step-1mm", "u-channel", "crack"}) {
        const Profile p = section_of(name);
        EXPECT_EQ(p.toe_chainage_m, 41.547) << name;
        EXPECT_EQ(crest_chainage(p), 30) << name;
        EXPECT_EQ(p.toe_elevation_m, 12) << name;
        EXPECT_EQ(p.doubts, std::vector<std::string>{}) << name;
    }
    const Profile wall = section_of("wall-road-platform");
    EXPECT_EQ(wall.toe_chainage_m, 28.6);
    EXPECT_EQ(wall.toe_elevation_m, 15.5);
    EXPECT_EQ(crest_chainage(wall), 18);
    EXPECT_EQ(wall.doubts, std::vector<std::string>{});
}

}  // namespace
