// The case that runout new writes: it can be run as it stands, and with any of its comments made a key.

#include "scene/new_case.h"

#include <sstream>

#include "core/units.h"
#include "drawn_files.h"
#include "random_sections.h"
#include "said.h"
#include "scene/case_file.h"
#include "scene/parameters.h"
#include "section_files.h"

namespace runout {
namespace {

const Polyline cut{{0, 32}, {30, 32}, {41.547, 12}, {201.547, 12}};

class NewCases : public SectionFiles {
  protected:
    [[nodiscard]] std::string folder() const { return path(""); }
    std::string text_for(const CaseSpec& spec) const { return new_case(spec, folder()).text; }
    Scene scene_of(const std::string& text) const { return make_scene(read_case(write("case.toml", text))); }
    [[nodiscard]] CaseSpec table(const Polyline& points) const {
        return read_case(write("section.csv", csv_text(points)));
    }
};

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

bool is_key_in_a_comment(const std::string& line) {
    const std::size_t equals = line.find(" = ");
    if (!line.starts_with("# ") || equals == std::string::npos) return false;
    const std::string_view name = std::string_view(line).substr(2, equals - 2);
    return std::ranges::any_of(parameters(), [&](const Parameter& parameter) {
        return parameter.key.substr(parameter.key.rfind('.') + 1) == name;
    });
}

bool is_chainage_of_face(const std::string& line) {
    return line.starts_with("# toe_chainage_m") || line.starts_with("# crest_chainage_m");
}

/// The text with the # taken from one key, of toe and crest from both.
std::string with_key(const std::vector<std::string>& lines, std::size_t taken) {
    const bool face = is_chainage_of_face(lines[taken]);
    std::string text;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const bool key = i == taken || (face && is_chainage_of_face(lines[i]));
        text += key ? lines[i].substr(2) : lines[i];
        text += '\n';
    }
    return text;
}

void expect_same(const Scene& a, const Scene& b) {
    ASSERT_EQ(a.profile.ground.size(), b.profile.ground.size());
    for (std::size_t i = 0; i < a.profile.ground.size(); ++i)
        EXPECT_LT((a.profile.ground[i] - b.profile.ground[i]).norm(), 1e-6);
    EXPECT_EQ(a.source.type, b.source.type);
    EXPECT_NEAR(a.source.area, b.source.area, 1e-6 * a.source.area);
    EXPECT_EQ(a.material.density, b.material.density);
    EXPECT_EQ(a.name, b.name);
}

TEST_F(NewCases, CanBeRunAsTheyStandAndWithEachOfTheirComments) {
    RandomSections sections(3);
    for (int k = 0; k < 40; ++k) {
        const Polyline section = sections.next();
        const std::vector<std::string> files = {
            write("s.csv", csv_text(section)), write("s.dxf", DxfText().polyline("EG", section).whole()),
            write("s.xml", landxml_text(metric_units, cross_section("20", surface_text("EG", {section}))))};
        const std::string& file = files[k % files.size()];
        SCOPED_TRACE(file + " " + csv_text(section));
        const std::string text = text_for(read_case(file));
        const Scene scene = scene_of(text);
        const std::vector<std::string> lines = lines_of(text);
        int keys = 0;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            if (!is_key_in_a_comment(lines[i])) continue;
            ++keys;
            SCOPED_TRACE(lines[i]);
            expect_same(scene_of(with_key(lines, i)), scene);
        }
        EXPECT_GE(keys, 5);
    }
}

TEST_F(NewCases, ExplainEachKeyAndSayWhatWasFound) {
    const std::string text = text_for(table(cut));
    for (const char* part :
         {"file = \"section.csv\"", "# toe_chainage_m = 41.547", "# crest_chainage_m = 30\n", "type = \"B\"",
          "base_angle_deg = 35", "scarp_angle_deg = 80", "friction_angle_deg = 38", "# An example!",
          "# density_kg_m3 = 2000", "# accuracy = \"5%\"", "this is a guess to begin with",
          "20 m high, 60.0 deg", "[effects.cohesion]", "[[place]]",
          "# Dip of the basal slip surface. (0 <= number < 90 deg; without it: 35)"})
        EXPECT_TRUE(contains(text, part));
    for (const std::string& line : lines_of(text)) EXPECT_LE(line.size(), 110u) << line;
}

TEST_F(NewCases, KeepWhatWasGiven) {
    CaseSpec spec = table(cut);
    override_value(spec, "material.friction_angle_deg", ".35e2", "--friction-angle");
    override_value(spec, "section.toe_chainage_m", "041.4", "--toe-chainage");
    override_value(spec, "source.type", "C", "--source");
    override_value(spec, "source.base_angle_deg", "40", "--base-angle");
    override_value(spec, "source.area_m2", "100", "--area");
    override_value(spec, "run.name", "the \"cut\"\nat \\ Shek O", "--name");
    override_value(spec, "run.resolution", "12", "--resolution");
    override_value(spec, "run.snapshot_times_s", "[1, 2]", "--set");
    override_value(spec, "effects.cohesion.cohesion_kpa", "2", "--set");
    const NewCase made = new_case(spec, folder());
    EXPECT_FALSE(made.example_friction);
    EXPECT_EQ(made.source_type, SourceType::c);
    const Scene scene = scene_of(made.text);
    EXPECT_DOUBLE_EQ(scene.material.friction_angle, radians(35));
    EXPECT_EQ(scene.profile.toe_chainage_m, 41.4);
    EXPECT_EQ(scene.name, "the \"cut\"\nat \\ Shek O");
    EXPECT_EQ(scene.run.resolution, 12);
    EXPECT_EQ(scene.run.snapshot_times, (std::vector<double>{1, 2}));
    EXPECT_TRUE(scene.effects.cohesion.has_value());
    EXPECT_NEAR(scene.source.area, make_site(spec).source.area, 1e-9);
}

TEST_F(NewCases, FindASourceForAGentleSlopeAndForAWall) {
    const NewCase gentle = new_case(table({{0, 20}, {30, 20}, {70, 5}, {200, 5}}), folder());
    EXPECT_EQ(gentle.source_type, SourceType::b);
    EXPECT_TRUE(contains(gentle.text, "base_angle_deg = 12"));  // of a face of 20.6 deg
    const NewCase wall = new_case(table({{0, 20}, {30, 20}, {30, 12}, {200, 12}}), folder());
    EXPECT_EQ(wall.source_type, SourceType::slip_surface);
    scene_of(wall.text);
}

TEST_F(NewCases, TakeTheSourceFromTheDrawing) {
    const DxfText drawing =
        DxfText().polyline("ground", cut).polyline("slip", {{27, 32}, {33, 20}, {41.547, 12}});
    const std::string text = text_for(read_case(write("s.dxf", drawing.whole())));
    EXPECT_TRUE(contains(text, "# type = \"slip_surface\""));
    EXPECT_TRUE(contains(text, "3 points of layer slip of s.dxf"));
    EXPECT_EQ(scene_of(text).source.type, SourceType::slip_surface);
    // One that does not fit is refused, and no other takes its place.
    const DxfText within = DxfText().polyline("ground", cut).polyline("slip", {{27, 30}, {33, 20}});
    EXPECT_TRUE(contains(input_error([&] { text_for(read_case(write("s.dxf", within.whole()))); }),
                         "inside the ground"));
}

TEST_F(NewCases, ASectionWithoutAFaceIsRefused) {
    EXPECT_TRUE(contains(input_error([&] {
                             text_for(table({{0, 10}, {50, 10}, {100, 10}}));
                         }),
                         "give toe and crest"));
}

}  // namespace
}  // namespace runout
