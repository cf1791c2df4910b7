#include <utility>

#include "core/units.h"
#include "scene/parameter_builders.h"
#include "scene/parameters.h"
#include "source/source_types.h"
#include "source/spec_check.h"

// The one place where a key of a case file is declared. Reading, range checks, `--set`, the options of
// `runout run` and `runout help keys` all follow from this table.

namespace runout {
namespace {

Words names_of_source_types() {
    Words names;
    for (const SourceTypeRow& row : source_types()) names.push_back(row.name);
    return names;
}

std::vector<Parameter> section_parameters() {
    return {
        word("section.file", {}, "required, unless section.line is given",
             "Cross-section: a text table, a drawing (DXF), LandXML, or lines in a local system "
             "(docs/sections.md); relative to the case file.",
             [](CaseSpec& spec, const std::string& path) { spec.section.file = path; }),
        number("section.toe_chainage_m", "m", any_number, "found on the section",
               "Chainage of the foot of the cut.",
               [](CaseSpec& spec, double metres) { spec.section.options.toe_chainage = Chainage(metres); }),
        number("section.crest_chainage_m", "m", any_number, "found on the section",
               "Chainage of the upper edge of the cut.",
               [](CaseSpec& spec, double metres) { spec.section.options.crest_chainage = Chainage(metres); }),
    };
}

SectionFileOptions& format_of(CaseSpec& spec) {
    return spec.section.format;
}

std::vector<Parameter> section_format_parameters() {
    return {
        word("section.columns", {}, "found by the header",
             "Columns of chainage and elevation in a table, by name or number: Station,Elev or 1,3.",
             [](CaseSpec& spec, const std::string& columns) { format_of(spec).columns = columns; }),
        word("section.decimal", {"point", "comma"}, "found in the numbers",
             "Decimal mark of the numbers in a table.",
             [](CaseSpec& spec, const std::string& mark) { format_of(spec).decimal = mark; }),
        word("section.unit", {"m", "cm", "mm", "ft", "us-ft", "in"}, "as the file says, else m",
             "Unit of chainage and elevation in a section of its own file; us-ft are US survey feet.",
             [](CaseSpec& spec, const std::string& unit) { format_of(spec).unit = unit; }),
        word("section.dxf_layers", {}, "layers called ground, source and slip; else the only one with lines",
             "Layers of a drawing: ground=NAME,source=NAME,slip=NAME, each optional; a source is an outline, "
             "a "
             "slip a slip line.",
             [](CaseSpec& spec, const std::string& names) { format_of(spec).dxf_layers = names; }),
        word("section.alignment", {}, "the only one", "Alignment of a LandXML file, by its name.",
             [](CaseSpec& spec, const std::string& name) { format_of(spec).landxml.alignment = name; }),
        word("section.station", {}, "the only one",
             "Cross-section of a LandXML file, by its station (120.5 or 0+120.5); or profile, the long "
             "profile.",
             [](CaseSpec& spec, const std::string& station) { format_of(spec).landxml.station = station; }),
        word("section.surface", {}, "the only one", "Surface of a LandXML cross-section, by its name.",
             [](CaseSpec& spec, const std::string& name) { format_of(spec).landxml.surface = name; }),
    };
}

LineQuery& line_of(CaseSpec& spec) {
    return spec.section.map.line;
}

std::vector<Parameter> line_parameters() {
    return {
        word("section.line", {}, "none",
             "Vector file (GDAL) with section lines; each line that is not left out is a section.",
             [](CaseSpec& spec, const std::string& path) { line_of(spec).file = path; }),
        word("section.layer", {}, "the only one",
             "Layer of section.line; the layers of a drawing are section.dxf_layers.",
             [](CaseSpec& spec, const std::string& name) { line_of(spec).layer = name; }),
        integer("section.feature_id", between(0, 2e9), "every line",
                "The one line to take, by its feature id.",
                [](CaseSpec& spec, int id) { line_of(spec).feature_id = id; }),
        word("section.where", {}, "every line",
             "The lines to take, as a condition on their attributes: slope_no = '11SW-D/C1'.",
             [](CaseSpec& spec, const std::string& condition) { line_of(spec).where = condition; }),
        word("section.line_crs", {}, "as the file says",
             "Coordinate system of the lines, such as EPSG:2326, where their file names none or a wrong one.",
             [](CaseSpec& spec, const std::string& name) { line_of(spec).crs = name; }),
    };
}

std::vector<Parameter> placing_parameters() {
    return {
        place("section.origin", "not on a map", "Where section.file lies on the map.",
              [](CaseSpec& spec, const Vec2& at) { spec.section.placing.origin = at; }),
        number(
            "section.origin_chainage_m", "m", any_number, "0", "Chainage at section.origin.",
            [](CaseSpec& spec, double metres) { spec.section.placing.origin_chainage = Chainage(metres); }),
        number("section.bearing_deg", "deg", between(-360, 360), "from section.towards",
               "Grid bearing of the section, clockwise from grid north, towards increasing chainage.",
               [](CaseSpec& spec, double angle) { spec.section.placing.bearing = radians(angle); }),
        place("section.towards", "from section.bearing_deg",
              "Another place on the section, towards increasing chainage, instead of a bearing.",
              [](CaseSpec& spec, const Vec2& at) { spec.section.placing.towards = at; }),
        word("section.crs", {}, "none", "Coordinate system of section.origin, such as EPSG:2326.",
             [](CaseSpec& spec, const std::string& name) { spec.section.placing.crs = name; }),
    };
}

std::vector<Parameter> raster_parameters() {
    return {
        word("section.raster", {}, "the elevations of the line itself",
             "Elevation raster (GDAL) to sample along section.line.",
             [](CaseSpec& spec, const std::string& path) { spec.section.map.raster = path; }),
        word("section.raster_crs", {}, "as the file says",
             "Coordinate system of the raster, such as EPSG:2326, where its file names none or a wrong one.",
             [](CaseSpec& spec, const std::string& name) { spec.section.map.options.crs = name; }),
        number("section.sampling_m", "m", positive, "half a raster cell",
               "Distance between samples of the raster.",
               [](CaseSpec& spec, double metres) { spec.section.map.sampling_m = metres; }),
        word("section.interpolation", {"bilinear", "cubic"}, "bilinear",
             "How an elevation follows from the raster cells around a sample.",
             [](CaseSpec& spec, const std::string& name) {
                 spec.section.map.options.interpolation =
                     name == "cubic" ? Interpolation::cubic : Interpolation::bilinear;
             }),
        word("section.elevation_unit", {"m", "ft", "us-ft"}, "m, unless the file says otherwise",
             "Unit of the elevations of a raster or of three-dimensional lines.",
             [](CaseSpec& spec, const std::string& unit) { spec.section.map.options.elevation_unit = unit; }),
        word("section.zero_elevation", {"refused", "ground"}, "refused",
             "What an elevation of 0 on a three-dimensional line is that stands alone among others far from "
             "it.",
             [](CaseSpec& spec, const std::string& what) {
                 spec.section.map.zero_is_ground = what == "ground";
             }),
        number("section.smoothing_m", "m", positive, "no smoothing",
               "Width of the window in which elevations on a map are smoothed by local regression.",
               [](CaseSpec& spec, double metres) { spec.section.map.smoothing_m = metres; }),
    };
}

std::vector<Parameter> source_shape_parameters() {
    return {
        word("source.type", names_of_source_types(), "B", "Shape of the moving mass (docs/source-shapes.md).",
             [](CaseSpec& spec, const std::string& name) { spec.source.type = source_type_named(name); }),
        number("source.base_angle_deg", "deg", from_to_below(0, 90), "35", "Dip of the basal slip surface.",
               [](CaseSpec& spec, double angle) { spec.source.base_angle = radians(angle); }),
        number("source.scarp_angle_deg", "deg", above_zero_up_to(90), "80",
               "Inclination of the back scarp; for B steeper than the face.",
               [](CaseSpec& spec, double angle) { spec.source.scarp_angle = radians(angle); }),
        number("source.area_m2", "m2", positive, "from the other sizes",
               "Cross-sectional area of the source.",
               [](CaseSpec& spec, double area) { spec.source.area = area; }),
        number("source.height_m", "m", positive,
               "B: the whole face, unless an area is given; C: down to the toe",
               "B: from the exit point P up to the apex; C: from P up to the crest.",
               [](CaseSpec& spec, double metres) { spec.source.height = metres; }),
        number("source.length_m", "m", positive, "from area and aspect ratio", "Length along the base.",
               [](CaseSpec& spec, double metres) { spec.source.length = metres; }),
        number("source.thickness_m", "m", positive, "from area and aspect ratio",
               "Thickness normal to the base.",
               [](CaseSpec& spec, double metres) { spec.source.thickness = metres; }),
        number("source.aspect_ratio", "", above_zero_up_to(100), "from length and thickness",
               "Length over thickness; the paper uses 1 to 3.",
               [](CaseSpec& spec, double ratio) { spec.source.aspect = ratio; }),
    };
}

std::vector<Parameter> source_place_parameters() {
    return {
        number("source.drop_height_m", "m", zero_or_more,
               "rectangle: head at the crest; A, B: base at the toe; C: follows",
               "Height H_d of the source above the toe, to the point named by drop_height_datum.",
               [](CaseSpec& spec, double metres) { spec.source.drop_height = metres; }),
        word("source.drop_height_datum", {"head", "base"}, "head",
             "The drop height is measured to the head (uppermost ground point) or to the lower end of the "
             "source.",
             [](CaseSpec& spec, const std::string& name) {
                 spec.source.datum = name == "base" ? DropDatum::base : DropDatum::head;
             }),
        number("source.discontinuity_angle_deg", "deg", above_zero_up_to(90), "55",
               "Plane through P above which the mass forms the front (S_front); 55 holds near a friction "
               "angle of 38.",
               [](CaseSpec& spec, double angle) { spec.source.discontinuity_angle = radians(angle); }),
        points("source.points", "required for polygon and slip_surface",
               "Corners of the polygon, or the slip line from end to end: [[chainage, elevation], ...] as "
               "in the section file.",
               [](CaseSpec& spec, const Polyline& corners) { spec.source.points = section_points(corners); }),
    };
}

std::vector<Parameter> material_parameters() {
    return {
        number("material.density_kg_m3", "kg/m3", between(100, 20000), "2000", "Bulk density.",
               [](CaseSpec& spec, double density) { spec.material.density = density; }),
        number("material.friction_angle_deg", "deg", from_to_below(0, 80), "required",
               "Internal friction angle at critical state.",
               [](CaseSpec& spec, double angle) { spec.material.friction_angle = radians(angle); }),
    };
}

std::vector<Parameter> physical_run_parameters() {
    return {
        word("run.name", {}, "name of the file or of its folder", "Name of the case in tables and reports.",
             [](CaseSpec& spec, const std::string& name) { spec.name = name; }),
        number("run.gravity_m_s2", "m/s2", between(0.001, 10000), "9.81", "Acceleration of gravity.",
               [](CaseSpec& spec, double gravity) { spec.run.gravity = gravity; }),
        number("run.time_limit_s", "s", positive,
               "60 sqrt(H/g), H the fall of the source to the lowest bed; more where friction is below 0.1",
               "Simulated time after which the run ends even if the mass still moves.",
               [](CaseSpec& spec, double seconds) { spec.run.time_limit = seconds; }),
        number("run.front_thickness_m", "m", positive, "3 % of sqrt(source area)",
               "The front is the farthest place where the soil is as thick as this.",
               [](CaseSpec& spec, double metres) { spec.run.front_thickness = metres; }),
        number("run.front_window_m", "m", positive, "30 % of sqrt(source area)",
               "Half-width of the window in which thickness and speed are taken (docs/front.md).",
               [](CaseSpec& spec, double metres) { spec.run.front_window = metres; }),
        numbers("run.snapshot_times_s", "s", zero_or_more, "none",
                "Instants of simulated time at which all particles are stored.",
                [](CaseSpec& spec, const std::vector<double>& times) { spec.run.snapshot_times = times; }),
    };
}

std::vector<Parameter> numerical_run_parameters() {
    return {
        word("run.accuracy", {}, "5%",
             "Numerical error that the run-out may have: a share (\"5%\"; of sqrt(S) where that is more) or "
             "a length (\"0.25 m\"). The "
             "cheapest "
             "spacing that meets it is chosen; excludes run.resolution and run.particle_spacing_m.",
             [](CaseSpec& spec, const std::string& text) { spec.accuracy = text; }),
        number("run.resolution", "", between(4, 2000), "chosen to meet run.accuracy",
               "sqrt(source area) over particle spacing.",
               [](CaseSpec& spec, double ratio) { spec.run.resolution = ratio; }),
        number("run.particle_spacing_m", "m", positive, "chosen to meet run.accuracy",
               "Distance between particles; excludes run.resolution.",
               [](CaseSpec& spec, double metres) { spec.run.particle_spacing = metres; }),
        number("run.courant", "", between(0.001, 0.4), "0.2",
               "C_max: no particle moves further than this share of the spacing in a step.",
               [](CaseSpec& spec, double courant) { spec.run.courant = courant; }),
        number("run.smoothing_ratio", "", between(1.15, 2), "1.3", "Smoothing length over particle spacing.",
               [](CaseSpec& spec, double ratio) { spec.run.smoothing_ratio = ratio; }),
        word("run.friction", {"projected", "explicit"}, "projected",
             "projected: the yield condition as a constraint, comes to rest; explicit: the paper as printed, "
             "creeps.",
             [](CaseSpec& spec, const std::string& name) {
                 spec.run.friction =
                     name == "explicit" ? FrictionScheme::explicit_ : FrictionScheme::projected;
             }),
        integer("run.friction_iterations", between(1, 1000), "6",
                "Iterations of the projected friction in a step.",
                [](CaseSpec& spec, int count) { spec.run.friction_iterations = count; }),
        number("run.pressure_tolerance", "", between(1e-12, 0.1), "0.01",
               "Relative residual at which the pressure equation counts as solved.",
               [](CaseSpec& spec, double tolerance) { spec.run.pressure_tolerance = tolerance; }),
        word("run.sleeping", {"on", "off"}, "on",
             "on: nothing is solved for soil at rest until something near it moves or its load changes; off: "
             "all is computed to the end.",
             [](CaseSpec& spec, const std::string& name) { spec.run.sleeping = name == "on"; }),
        integer(
            "run.lattice_seed", between(0, 1e9), "0",
            "0: particles start on a regular lattice; else off it at random, to see how much that matters.",
            [](CaseSpec& spec, int seed) { spec.run.lattice_seed = seed; }),
        integer("run.threads", between(1, 1024), "all cores", "Threads of the run.",
                [](CaseSpec& spec, int count) { spec.run.threads = count; }),
    };
}

std::vector<Parameter> whole_table() {
    std::vector<Parameter> table;
    for (const auto& part :
         {section_parameters(), section_format_parameters(), line_parameters(), raster_parameters(),
          placing_parameters(), source_shape_parameters(), source_place_parameters(), material_parameters(),
          effect_parameters(), physical_run_parameters(), numerical_run_parameters()})
        table.insert(table.end(), part.begin(), part.end());
    for (Parameter& parameter : table) parameter.applies_to = types_using(parameter.key);
    return table;
}

}  // namespace

std::span<const Parameter> parameters() {
    static const std::vector<Parameter> table = whole_table();
    return table;
}

}  // namespace runout
