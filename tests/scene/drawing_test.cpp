// Sections in drawings (DXF): what is read equals what was drawn, and every refusal is a sentence.

#include <cmath>
#include <numbers>

#include "drawn_files.h"
#include "profile/profile.h"
#include "random_sections.h"
#include "said.h"
#include "scene/case_file.h"
#include "scene/scene.h"
#include "section_files.h"

namespace runout {
namespace {

using Release = DxfText::Release;

const Polyline cut{{0, 32}, {30, 32}, {41.547, 12}, {201.547, 12}};

class Drawings : public SectionFiles {
  protected:
    [[nodiscard]] SectionContent content(const DxfText& drawing,
                                         const SectionFileOptions& options = {}) const {
        return read_section_file(write("section.dxf", drawing.whole()), options);
    }
    [[nodiscard]] Polyline ground(const DxfText& drawing, const SectionFileOptions& options = {}) const {
        return content(drawing, options).section.points;
    }
    [[nodiscard]] std::string refusal(const std::string& text, const SectionFileOptions& options = {}) const {
        const std::string file = write("section.dxf", text);
        return input_error([&] { read_section_file(file, options); });
    }
    [[nodiscard]] std::string refusal(const DxfText& drawing, const SectionFileOptions& options = {}) const {
        return refusal(drawing.whole(), options);
    }
    [[nodiscard]] CaseSpec spec(const DxfText& drawing) const {
        return read_case(write("section.dxf", drawing.whole()));
    }
};

// ---- the ground

TEST_F(Drawings, OnePolylineIsTheGroundWithoutAnyKey) {
    for (const Release release : {Release::r12, Release::r2000}) {
        const SectionContent read = content(DxfText(release).polyline("0", cut));
        EXPECT_EQ(read.section.points, cut);
        EXPECT_TRUE(contains(read.section.read_as, "ground: 1 line on layer 0"));
        EXPECT_TRUE(contains(read.section.read_as, "in metres, as the drawing says nothing else"));
    }
}

TEST_F(Drawings, LinesInAnyOrderAndDirectionAreTheSameGround) {
    RandomSections sections(1);
    for (int k = 0; k < 60; ++k) {
        const Polyline section = sections.next();
        const Release release = k % 2 == 0 ? Release::r12 : Release::r2000;
        DxfText drawing(release);
        for (const Polyline& piece : sections.cut_into_pieces(section))
            if (piece.size() == 2 && k % 3 != 0)
                drawing.line("ground", piece[0], piece[1]);
            else
                drawing.polyline("ground", piece);
        ASSERT_EQ(ground(drawing), section) << k;
    }
}

TEST_F(Drawings, EndsMeetWithinTheToleranceAndNoFurther) {
    DxfText near;
    near.line("g", {0, 32}, {30, 32})
        .line("g", {30.003, 32.004}, {41.547, 12})
        .line("g", {41.547, 12}, {202, 12});
    EXPECT_EQ(ground(near), (Polyline{{0, 32}, {30, 32}, {41.547, 12}, {202, 12}}));
    DxfText far;
    far.line("g", {0, 32}, {30, 32})
        .line("g", {30.03, 32.04}, {41.547, 12})
        .line("g", {41.547, 12}, {202, 12});
    const std::string said = refusal(far);
    EXPECT_TRUE(contains(said, "has a gap between (30, 32) and (30.03, 32.04)"));
    EXPECT_TRUE(contains(said, "ends meet that are no more than 0.01 m apart"));
}

TEST_F(Drawings, AVerticalFaceStaysVertical) {
    const Polyline wall{{0, 32}, {30, 32}, {30, 20}, {41.5, 12}, {200, 12}};
    DxfText drawing;
    for (std::size_t i = 1; i < wall.size(); ++i) drawing.line("g", wall[i], wall[i - 1]);
    EXPECT_EQ(ground(drawing), wall);
    // Drawn a hair out of plumb, it is no overhang.
    EXPECT_EQ(ground(DxfText().polyline("g", {{0, 32}, {30, 32}, {29.9999, 20}, {41.5, 12}, {200, 12}})),
              wall);
}

TEST_F(Drawings, AnOverhangIsRefused) {
    const SectionContent read = content(DxfText().polyline("g", {{0, 32}, {30, 32}, {28, 20}, {200, 12}}));
    EXPECT_TRUE(contains(input_error([&] { make_profile(read.section, {}); }), "which is an overhang"));
}

TEST_F(Drawings, WhatIsNoSingleLineIsRefusedWithItsPlace) {
    EXPECT_TRUE(contains(
        refusal(DxfText().polyline("g", cut).line("g", {30, 32}, {35, 40}).line("g", {0, 32}, {-5, 33})),
        "lines that do not meet"));
    EXPECT_TRUE(contains(
        refusal(DxfText().polyline("g", cut).line("g", {0, 32}, {-5, 33}).line("g", {0, 32}, {-5, 40})),
        "has more than two lines that meet at (0, 32)"));
    EXPECT_TRUE(contains(refusal(DxfText().polyline("g", cut, true)), "closes on itself"));
    EXPECT_TRUE(contains(refusal(DxfText().polyline("g", cut).polyline("g", {{10, 20}, {150, 11}})),
                         "one above the other between chainage 10 and 150"));
    EXPECT_TRUE(contains(refusal(DxfText().line("g", {3, 4}, {3, 4})), "no line that is longer than a dot"));
}

TEST_F(Drawings, ALineDrawnTwiceCountsOnce) {
    EXPECT_EQ(
        ground(DxfText().polyline("g", cut).polyline("g", {cut.rbegin(), cut.rend()}).polyline("g", cut)),
        cut);
}

TEST_F(Drawings, TextsHatchesBlocksAndPaperAreLeftOut) {
    DxfText drawing;
    drawing.polyline("g", cut).text("g", {10, 50}, "GROUND").text("notes", {0, 0}, "0+000");
    drawing.entity("POINT", "g", " 10\n5\n 20\n7\n");
    drawing.entity("INSERT", "g", "  2\nTREE\n 10\n5\n 20\n7\n");
    drawing.entity("LINE", "frame", " 67\n1\n 10\n0\n 20\n0\n 11\n420\n 21\n0\n");
    drawing.entity(
        "HATCH", "fill",
        "  2\nSOLID\n 70\n1\n 71\n0\n 91\n1\n 92\n2\n 72\n0\n 73\n1\n 93\n3\n 10\n0\n 20\n0\n 10\n9\n"
        " 20\n0\n 10\n9\n 20\n9\n 97\n0\n 75\n0\n 76\n1\n 98\n0\n");
    EXPECT_EQ(ground(drawing), cut);
}

// ---- curves

TEST_F(Drawings, ABulgeIsBrokenWithinItsTolerance) {
    // A quarter of a circle of 20 m about (50, 32), from the level top down to the foot.
    const double quarter = std::tan(std::numbers::pi / 8);
    const Polyline read =
        ground(DxfText().polyline("g", {{0, 32}, {30, 32}, {50, 12}, {200, 12}}, false, {0, quarter, 0, 0}));
    ASSERT_GE(read.size(), 90u);
    int on_arc = 0;
    for (std::size_t i = 1; i < read.size(); ++i) {
        const Vec2 middle = (read[i] + read[i - 1]) / 2;
        if (read[i - 1].x() < 29.999 || read[i].x() > 50.001) continue;
        ++on_arc;
        EXPECT_NEAR((middle - Vec2(50, 32)).norm(), 20, 4e-5 * 20);
    }
    EXPECT_GE(on_arc, 89);
    EXPECT_LT((read[1] - Vec2(30, 32)).norm(), 1e-9);
    EXPECT_EQ(read.back(), Vec2(200, 12));
}

TEST_F(Drawings, AnArcMeetsTheLinesBesideIt) {
    const Polyline read = ground(DxfText()
                                     .line("g", {0, 32}, {30, 32})
                                     .arc("g", {50, 32}, 20, 180, 270)
                                     .line("g", {200, 12}, {50, 12}));
    EXPECT_NEAR(read[46].x(), 50 - 20 * std::cos(radians(45)), 1e-9);
    EXPECT_NEAR(read[46].y(), 32 - 20 * std::sin(radians(45)), 1e-9);
}

TEST_F(Drawings, ASplineSaysHowFarItsPiecesMayBeOff) {
    const Polyline control{{0, 32}, {20, 32}, {30, 30}, {45, 12}, {60, 12}, {200, 12}};
    const SectionContent read = content(DxfText().spline("g", 3, control));
    ASSERT_EQ(read.section.points.size(), 8 * control.size());
    EXPECT_LT((read.section.points.front() - control.front()).norm(), 1e-6);
    EXPECT_LT((read.section.points.back() - control.back()).norm(), 1e-6);
    EXPECT_TRUE(contains(read.section.read_as, "splines in pieces that are up to about"));
    // Of degree one it is its control points joined by straight lines, which all points lie on.
    for (const Vec2& p : ground(DxfText().spline("g", 1, {{0, 32}, {100, 12}, {200, 12}})))
        EXPECT_NEAR(p.y(), p.x() < 100 ? 32 - 0.2 * p.x() : 12, 1e-6);
}

TEST_F(Drawings, ASplineThatCannotBeReadIsNoHole) {
    EXPECT_TRUE(contains(refusal(DxfText().polyline("g", cut).spline_of_fit_points("g", cut)),
                         "has 2 lines, of which 1 can be read"));
}

// ---- layers

TEST_F(Drawings, SeveralLayersWithLinesAreListed) {
    const DxfText drawing =
        DxfText().polyline("EG", cut).polyline("road", {{50, 12}, {60, 12}}).line("road", {1, 2}, {3, 4});
    const std::string said = refusal(drawing);
    EXPECT_TRUE(contains(said, "lines on 2 layers"));
    EXPECT_TRUE(contains(said, "--layer ground=NAME"));
    EXPECT_TRUE(contains(said, "EG (1 line), road (2 lines)"));
    EXPECT_EQ(ground(drawing, {.dxf_layers = "ground=EG"}), cut);
    EXPECT_EQ(ground(drawing, {.dxf_layers = "eg"}), cut);
    EXPECT_TRUE(
        contains(refusal(drawing, {.dxf_layers = "ground=XY"}), "names the layer XY, which has no lines"));
    EXPECT_TRUE(contains(refusal(drawing, {.dxf_layers = "ground=EG,ground=road"}), "names two layers"));
    EXPECT_TRUE(contains(refusal(drawing, {.dxf_layers = "ground="}), "names no layer"));
}

TEST_F(Drawings, ALayerMayHaveACommaInItsName) {
    const DxfText drawing = DxfText().polyline("EG, 2024", cut).polyline("S,x", {{27, 32}, {41.547, 12}});
    const SectionContent read = content(drawing, {.dxf_layers = "ground=EG, 2024,slip=S,x"});
    EXPECT_EQ(read.section.points, cut);
    EXPECT_EQ(read.mass.slip_line, (std::vector<SectionPoint>{{27, 32}, {41.547, 12}}));
}

// ---- units

TEST_F(Drawings, TheUnitIsThatOfTheDrawingUnlessTheKeySaysAnother) {
    const auto scaled = [](double by) {
        Polyline points = cut;
        for (Vec2& p : points) p *= by;
        return points;
    };
    const auto expect_cut = [](const Polyline& read) {
        ASSERT_EQ(read.size(), cut.size());
        for (std::size_t i = 0; i < cut.size(); ++i) EXPECT_LT((read[i] - cut[i]).norm(), 1e-9);
    };
    expect_cut(ground(DxfText().variable("$INSUNITS", 4).polyline("g", scaled(1000))));
    expect_cut(ground(DxfText().variable("$INSUNITS", 5).polyline("g", scaled(100))));
    expect_cut(ground(DxfText().variable("$INSUNITS", 6).polyline("g", cut)));
    expect_cut(ground(DxfText().variable("$INSUNITS", 2).polyline("g", scaled(1 / 0.3048))));
    expect_cut(ground(DxfText().variable("$INSUNITS", 21).polyline("g", scaled(3937.0 / 1200))));
    expect_cut(ground(DxfText().variable("$INSUNITS", 4).polyline("g", cut), {.unit = "m"}));
    EXPECT_TRUE(contains(content(DxfText().variable("$INSUNITS", 2).polyline("g", cut)).section.read_as,
                         "in feet (0.3048 m), as $INSUNITS says"));
}

TEST_F(Drawings, ADoubtfulUnitIsRefused) {
    // What programs begin with: metres drawn in a file that is marked as millimetres or inches.
    const std::string said = refusal(DxfText().variable("$INSUNITS", 4).polyline("g", cut));
    EXPECT_TRUE(contains(said, "$INSUNITS says millimetres, in which the section is 0.202 m long"));
    EXPECT_TRUE(contains(said, "give --unit mm or --unit m"));
    EXPECT_TRUE(contains(refusal(DxfText().variable("$INSUNITS", 1).polyline("g", cut)), "says inches"));
    EXPECT_TRUE(contains(refusal(DxfText().variable("$MEASUREMENT", 0).polyline("g", cut)), "not metric"));
    EXPECT_TRUE(contains(refusal(DxfText().variable("$INSUNITS", 3).polyline("g", cut)),
                         "$INSUNITS = 3: is a unit that no section is drawn in"));
    Polyline millimetres = cut;
    for (Vec2& p : millimetres) p *= 1000;
    EXPECT_TRUE(contains(refusal(DxfText().polyline("g", millimetres)), "say its unit with --unit"));
}

TEST_F(Drawings, APlanIsNoSection) {
    const std::string said = refusal(DxfText().polyline("g", {{834021, 815901}, {834341, 815950}}));
    EXPECT_TRUE(contains(said, "y = 815901: is the elevation of no ground"));
    EXPECT_TRUE(contains(said, "section.line"));
    EXPECT_TRUE(
        contains(refusal(DxfText().entity("LINE", "g", " 10\n0\n 20\n5\n 30\n1\n 11\n9\n 21\n5\n 31\n4\n")),
                 "has lines in three dimensions"));
    EXPECT_TRUE(contains(refusal(DxfText().polyline("g", {{0, 32}, {30, -9999}, {40, 12}})), "-9999"));
    EXPECT_TRUE(
        contains(refusal(DxfText().polyline("g", {{0, 32}, {30, 2032}, {40, 12}})), "more than 1000 m"));
}

// ---- what is drawn with the ground

const Polyline slip{{27, 32}, {33, 20}, {41.547, 12}};

TEST_F(Drawings, ASlipLineIsTheSource) {
    const DxfText drawing = DxfText().polyline("GROUND", cut).polyline("SLIP", {slip.rbegin(), slip.rend()});
    const Site site = make_site(spec(drawing));
    EXPECT_EQ(site.source.type, SourceType::slip_surface);
    ASSERT_EQ(site.assumed.size(), 2u);
    EXPECT_EQ(site.assumed[0], "source.type = slip_surface, as drawn");
    EXPECT_EQ(site.assumed[1], "source.points = the 3 points of layer SLIP of section.dxf");

    CaseSpec said = spec(DxfText().polyline("g", cut));
    override_value(said, "source.type", "slip_surface", "--source");
    override_value(said, "source.points", "[[27, 32], [33, 20], [41.547, 12]]", "--set");
    EXPECT_EQ(make_site(said).source.outline, site.source.outline);
}

TEST_F(Drawings, AnOutlineIsTheSource) {
    for (const Release release : {Release::r12, Release::r2000}) {
        const DxfText drawing = DxfText(release)
                                    .polyline("ground", cut)
                                    .polyline("source", {{30, 32}, {41.547, 12}, {30, 25}}, true);
        const Site site = make_site(spec(drawing));
        EXPECT_EQ(site.source.type, SourceType::polygon);
        EXPECT_NEAR(site.source.area, 0.5 * 7 * 11.547, 1e-9);
    }
    EXPECT_TRUE(
        contains(refusal(DxfText().polyline("ground", cut).polyline("source", slip)), "is not closed"));
}

TEST_F(Drawings, TheCaseOverridesWhatIsDrawn) {
    const DxfText drawing = DxfText().polyline("ground", cut).polyline("slip", slip);
    CaseSpec sized = spec(drawing);
    override_value(sized, "source.base_angle_deg", "40", "--base-angle");
    EXPECT_EQ(make_site(sized).source.type, SourceType::b);
    CaseSpec typed = spec(drawing);
    override_value(typed, "source.type", "B", "--source");
    EXPECT_EQ(make_site(typed).source.type, SourceType::b);
    CaseSpec pointed = spec(drawing);
    override_value(pointed, "source.type", "slip_surface", "--source");
    override_value(pointed, "source.points", "[[28, 32], [41.547, 12]]", "--set");
    EXPECT_NEAR(make_site(pointed).source.area, 0.5 * 2 * 20, 1e-9);
}

TEST_F(Drawings, AnOutlineAndASlipLineNeedAChoice) {
    const DxfText drawing = DxfText()
                                .polyline("ground", cut)
                                .polyline("slip", slip)
                                .polyline("source", {{30, 32}, {41.547, 12}, {30, 25}}, true);
    EXPECT_TRUE(contains(input_error([&] { make_site(spec(drawing)); }), "give polygon or slip_surface"));
    CaseSpec chosen = spec(drawing);
    override_value(chosen, "source.type", "polygon", "--source");
    EXPECT_EQ(make_site(chosen).source.type, SourceType::polygon);
}

TEST_F(Drawings, KeysOfAnotherFormatAreRefused) {
    CaseSpec table = read_case(write("section.csv", csv_text(cut)));
    override_value(table, "section.dxf_layers", "ground=g", "--layer");
    EXPECT_TRUE(contains(input_error([&] { make_ground(table); }), "does not apply to a table"));
    CaseSpec drawing = spec(DxfText().polyline("g", cut));
    override_value(drawing, "section.station", "20", "--station");
    EXPECT_TRUE(contains(input_error([&] { make_ground(drawing); }), "it belongs to LandXML"));
}

// ---- hostile and broken files

TEST_F(Drawings, ABrokenFileIsRefused) {
    EXPECT_TRUE(
        contains(refusal(DxfText().polyline("g", cut).unfinished()), "ends in the middle of its entities"));
    EXPECT_TRUE(contains(refusal("AutoCAD Binary DXF\r\n\x1a"), "is a binary DXF; save it as ASCII DXF"));
    EXPECT_TRUE(contains(refusal(""), "has no entities"));
    EXPECT_TRUE(contains(refusal(DxfText()), "has no lines in its model space"));
    EXPECT_TRUE(contains(
        refusal("0\nSECTION\n2\nENTITIES\n0\nLINE\n8\ng\n10\n0\n20\n0\n11\nnan\n21\n1\n0\nENDSEC\n0\nEOF\n"),
        "section.dxf"));
    EXPECT_TRUE(contains(refusal(DxfText().polyline("g", {{0, 1}, {1e300, 1}})), "section.dxf"));
    EXPECT_TRUE(contains(input_error([&] { read_section_file(path("none.dxf"), {}); }), "cannot be opened"));
}

TEST_F(Drawings, BombsAreRefusedWithTheLimit) {
    DxfText array;
    array.polyline("g", cut).entity("INSERT", "g", "  2\nTREE\n 10\n5\n 20\n7\n 70\n32000\n 71\n32000\n");
    EXPECT_TRUE(contains(refusal(array), "more than 500000 entities"));
    Polyline control;
    for (int i = 0; i < 2001; ++i) control.emplace_back(i, std::sin(0.01 * i));
    EXPECT_TRUE(contains(refusal(DxfText().spline("g", 3, control)), "has 2001 control points"));
}

}  // namespace
}  // namespace runout
