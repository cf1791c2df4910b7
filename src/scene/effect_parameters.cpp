#include <cmath>

#include "core/units.h"
#include "scene/parameter_builders.h"

namespace runout {
namespace {

/// The effect that a key belongs to: named by it, so there from now on.
template <class Effect>
Effect& named(std::optional<Effect>& effect) {
    if (!effect) effect.emplace();
    return *effect;
}

template <class Entry>
Entry& latest(std::vector<Entry>& entries) {
    if (entries.empty()) entries.emplace_back();
    return entries.back();
}

void set_friction_ranges(CaseSpec& spec, const NumberRows& table) {
    auto& ranges = named(spec.effects.base_friction).ranges;
    ranges.clear();
    for (const auto& row : table) ranges.push_back({row[0], row[1], radians(row[2])});
}

std::vector<Parameter> base_friction_parameters() {
    return {
        number(
            "effects.base_friction.angle_deg", "deg", from_to_below(0, 80), "off: a rough bed",
            "Friction angle between soil and bed, where its tangent is below the sine of the soil's own.",
            [](CaseSpec& spec, double angle) { named(spec.effects.base_friction).angle = radians(angle); }),
        rows(
            "effects.base_friction.ranges", {"from chainage m", "to chainage m", "angle deg"}, "none",
            "Parts of the bed with a friction angle of their own; elsewhere angle_deg holds, or a rough bed.",
            set_friction_ranges),
    };
}

std::vector<Parameter> strength_parameters() {
    return {
        number("effects.cohesion.cohesion_kpa", "kPa", between(0, 1e6), "off: none",
               "Cohesion c of the soil: it yields at c cos(phi) + p sin(phi).",
               [](CaseSpec& spec, double kpa) { named(spec.effects.cohesion).strength = 1e3 * kpa; }),
        number("effects.cohesion.tension_cut_off_kpa", "kPa", between(0, 1e6),
               "c cos(phi)/(1 + sin(phi)), uniaxial tension at yield",
               "Greatest mean tension that the soil bears.",
               [](CaseSpec& spec, double kpa) { named(spec.effects.cohesion).tension = 1e3 * kpa; }),
        number("effects.rate.grain_diameter_m", "m", between(1e-7, 10),
               "off: friction does not depend on the rate",
               "Grain diameter d of the inertial number I = 2|e| d sqrt(rho_s/p): friction grows as mu(I).",
               [](CaseSpec& spec, double metres) { named(spec.effects.rate).grain_diameter = metres; }),
        number("effects.rate.grain_density_kg_m3", "kg/m3", between(100, 20000), "2650",
               "Density rho_s of the grains.",
               [](CaseSpec& spec, double density) { named(spec.effects.rate).grain_density = density; }),
        number("effects.rate.friction_increase", "", between(0, 10), "0.26",
               "mu_2 - mu_s: friction coefficient at high rates less that at rest, sin(phi).",
               [](CaseSpec& spec, double increase) { named(spec.effects.rate).increase = increase; }),
        number("effects.rate.inertial_number", "", between(1e-6, 1000), "0.279",
               "I_0 at which half of the increase is there.",
               [](CaseSpec& spec, double number) { named(spec.effects.rate).inertial_number = number; }),
    };
}

void set_ratio_points(CaseSpec& spec, const NumberRows& table) {
    auto& field = named(spec.effects.pore_pressure).field;
    field.clear();
    for (const auto& row : table) field.emplace_back(row[0], row[1]);
}

std::vector<Parameter> water_parameters() {
    return {
        number("effects.pore_pressure.ratio", "", between(0, 1), "0",
               "r_u of the whole mass: pore pressure over density x gravity x vertical depth.",
               [](CaseSpec& spec, double ratio) { named(spec.effects.pore_pressure).ratio = ratio; }),
        rows("effects.pore_pressure.ratio_points", {"chainage m", "r_u"}, "none",
             "r_u by the chainage where the soil starts, linear between the points; excludes ratio.",
             set_ratio_points),
        number("effects.pore_pressure.base_excess_ratio", "", between(0, 1), "0",
               "More of it at release in the soil next to the bed (liquefied base).",
               [](CaseSpec& spec, double ratio) { named(spec.effects.pore_pressure).base_excess = ratio; }),
        number("effects.pore_pressure.dissipation_time_s", "s", positive, "it stays",
               "Time in which the excess at the base falls to 1/e.",
               [](CaseSpec& spec, double seconds) {
                   named(spec.effects.pore_pressure).dissipation_time = seconds;
               }),
    };
}

std::vector<Parameter> barrier_parameters() {
    return {
        number("effects.barrier.chainage_m", "m", any_number, "off: no barrier",
               "Foot of the face of a rigid barrier that the debris meets.",
               [](CaseSpec& spec, double metres) { named(spec.effects.barrier).x = metres; }),
        number("effects.barrier.height_m", "m", positive, "required with chainage_m",
               "Height of the barrier.",
               [](CaseSpec& spec, double metres) { named(spec.effects.barrier).height = metres; }),
        number(
            "effects.barrier.inclination_deg", "deg", between(20, 90), "90",
            "Inclination of its face against the horizontal.",
            [](CaseSpec& spec, double angle) { named(spec.effects.barrier).inclination = radians(angle); }),
        number("effects.barrier.thickness_m", "m", positive, "half the height", "Thickness at its top.",
               [](CaseSpec& spec, double metres) { named(spec.effects.barrier).thickness = metres; }),
        number("effects.barrier.load_coefficient", "", positive, "2.5",
               "alpha of the design load alpha rho v^2 that the computed force is compared with.",
               [](CaseSpec& spec, double alpha) { named(spec.effects.barrier).load_coefficient = alpha; }),
    };
}

std::vector<Parameter> shaking_parameters() {
    return {
        word(
            "effects.shaking.record", {}, "off: the ground is still",
            "CSV of the ground's acceleration: time_s, horizontal_m_s2 (towards the run-out) and, if wanted, "
            "vertical_m_s2; relative to the case file.",
            [](CaseSpec& spec, const std::string& path) {
                named(spec.effects.shaking);
                spec.shaking_record = path;
            }),
        number("effects.shaking.horizontal_coefficient", "g", between(-2, 2), "0",
               "Pseudo-static: constant force on the soil towards the run-out over its weight.",
               [](CaseSpec& spec, double k) {
                   named(spec.effects.shaking);
                   spec.pseudo_static.x() = k;
               }),
        number("effects.shaking.vertical_coefficient", "g", from_to_below(-1, 1), "0",
               "Pseudo-static: constant upward force on the soil over its weight.",
               [](CaseSpec& spec, double k) {
                   named(spec.effects.shaking);
                   spec.pseudo_static.y() = k;
               }),
    };
}

std::vector<Parameter> channel_parameters() {
    return {
        number("effects.side_walls.width_m", "m", positive, "off: infinitely wide",
               "Width of the channel between two vertical walls.",
               [](CaseSpec& spec, double metres) { named(spec.effects.side_walls).width = metres; }),
        number("effects.side_walls.friction_angle_deg", "deg", from_to_below(0, 80), "required with width_m",
               "Friction angle between the soil and these walls.",
               [](CaseSpec& spec, double angle) { named(spec.effects.side_walls).angle = radians(angle); }),
    };
}

std::vector<Parameter> release_parameters() {
    return {
        integer(
            "effects.release.layers", between(1, 10000), "off: all at once",
            "Pouring: number of layers, each let go above the uphill end of the soil when that has come to "
            "rest.",
            [](CaseSpec& spec, int count) { named(spec.effects.release).layers = count; }),
        number("effects.release.layer_width_m", "m", positive, "required with layers", "Width of a layer.",
               [](CaseSpec& spec, double metres) { named(spec.effects.release).layer_width = metres; }),
        number("effects.release.layer_height_m", "m", positive, "required with layers", "Height of a layer.",
               [](CaseSpec& spec, double metres) { named(spec.effects.release).layer_height = metres; }),
        number("effects.release.mass.time_s", "s", above_zero_up_to(86400), "none",
               "[[effects.release.mass]], one each: when a further mass is let go.",
               [](CaseSpec& spec, double seconds) {
                   latest(named(spec.effects.release).masses).time = seconds;
               }),
        points("effects.release.mass.points", "required for each mass",
               "Corners of that mass: [[chainage, elevation], ...]; what of it lies in the hill leaves the "
               "hill.",
               [](CaseSpec& spec, const Polyline& corners) {
                   latest(named(spec.effects.release).masses).mass.outline = corners;
               }),
    };
}

std::vector<Parameter> bed_parameters() {
    return {
        number("effects.erodible_bed.depth_m", "m", positive, "off: a rigid bed",
               "Vertical depth of a layer of the same soil in the bed that moves when it yields.",
               [](CaseSpec& spec, double metres) { named(spec.effects.erodible_bed).depth = metres; }),
        number("effects.erodible_bed.from_chainage_m", "m", any_number, "required with depth_m",
               "Chainage where the layer begins.",
               [](CaseSpec& spec, double metres) { named(spec.effects.erodible_bed).from = metres; }),
        number("effects.erodible_bed.to_chainage_m", "m", any_number, "required with depth_m",
               "Chainage where the layer ends.",
               [](CaseSpec& spec, double metres) { named(spec.effects.erodible_bed).to = metres; }),
    };
}

std::vector<Parameter> place_parameters() {
    return {
        number(
            "place.chainage_m", "m", any_number, "none",
            "[[place]], one each: near edge of what may be reached; thickness, speed, arrival and passing of "
            "the debris are told there. [[gauge]] is another word for it.",
            [](CaseSpec& spec, double metres) { latest(spec.places).x = metres; }),
        word("place.name", {}, "place-1, place-2, ...", "Its name in tables and reports.",
             [](CaseSpec& spec, const std::string& name) { latest(spec.places).name = name; }),
        number("place.width_m", "m", zero_or_more, "0, a line", "From the near edge away from the cut.",
               [](CaseSpec& spec, double metres) { latest(spec.places).width = metres; }),
        word("place.kind", {}, "not said", "What it is: building, road, barrier line, ...",
             [](CaseSpec& spec, const std::string& kind) { latest(spec.places).kind = kind; }),
    };
}

std::vector<Parameter> map_place_parameters() {
    return {
        word("places.file", {}, "none",
             "Points, lines or polygons (GDAL) on a map; those near the section line are places.",
             [](CaseSpec& spec, const std::string& path) { spec.map_places.file = path; }),
        word("places.layer", {}, "the only one", "Layer of places.file.",
             [](CaseSpec& spec, const std::string& name) { spec.map_places.layer = name; }),
        word("places.where", {}, "all features", "Which features: a condition on their fields.",
             [](CaseSpec& spec, const std::string& condition) { spec.map_places.where = condition; }),
        word("places.crs", {}, "as the file says",
             "Coordinate system of places.file, such as EPSG:2326, where it names none or a wrong one.",
             [](CaseSpec& spec, const std::string& name) { spec.map_places.crs = name; }),
        word("places.name_field", {}, "name, where there is one", "Field with the name of a place.",
             [](CaseSpec& spec, const std::string& name) { spec.map_places.name_field = name; }),
        word("places.kind_field", {}, "kind, where there is one", "Field that says what a place is.",
             [](CaseSpec& spec, const std::string& name) { spec.map_places.kind_field = name; }),
        number("places.max_offset_m", "m", positive, "50", "How far from the section line a place may lie.",
               [](CaseSpec& spec, double metres) { spec.map_places.max_offset_m = metres; }),
    };
}

}  // namespace

bool is_list_section(std::string_view section) {
    return section == "place" || section == "effects.release.mass";
}

void begin_entry(CaseSpec& spec, std::string_view section) {
    if (section == "place") {
        spec.places.push_back({.x = std::nan("")});
    } else {
        named(spec.effects.release).masses.push_back({std::nan(""), {}});
    }
}

std::vector<Parameter> effect_parameters() {
    std::vector<Parameter> table;
    for (const auto& part :
         {base_friction_parameters(), strength_parameters(), water_parameters(), barrier_parameters(),
          shaking_parameters(), channel_parameters(), release_parameters(), bed_parameters(),
          place_parameters(), map_place_parameters()})
        table.insert(table.end(), part.begin(), part.end());
    return table;
}

}  // namespace runout
