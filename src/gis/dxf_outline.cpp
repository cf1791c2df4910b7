#include "gis/dxf_outline.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>

#include "core/input_error.h"
#include "core/words.h"

namespace runout {
namespace {

// GDAL works a spline out in a time that grows with the square of its control points.
constexpr long most_control_points = 2000;

/// A code and its value: a DXF is a list of these, two lines each.
struct Pair {
    int code = -1;
    std::string value;
    long line = 0;  ///< of the value
};

int integer_in(std::string_view text) {
    int value = -1;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

class Pairs {
  public:
    explicit Pairs(const std::string& path) : path_(path) {
        // Opening a pipe would wait for somebody to write into it.
        std::error_code failure;
        if (std::filesystem::is_regular_file(path, failure)) stream_.open(path, std::ios::binary);
        if (!stream_.is_open())
            throw InputError({path, 0, "", ""}, "cannot be opened", "give the path of a drawing (.dxf)");
    }

    std::optional<Pair> next() {
        std::string code;
        Pair pair;
        if (!std::getline(stream_, code) || !std::getline(stream_, pair.value)) return std::nullopt;
        lines_ += 2;
        if (lines_ == 2 && code.starts_with("AutoCAD Binary DXF"))
            throw InputError({path_, 0, "", ""}, "is a binary DXF", "save it as ASCII DXF");
        pair.code = group_code(trimmed(code));
        pair.value = std::string(trimmed(pair.value));
        pair.line = lines_;
        return pair;
    }

  private:
    /// GDAL looks for ever for the end of a file whose codes and values have changed places.
    [[nodiscard]] int group_code(std::string_view text) const {
        int code = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), code);
        if (error == std::errc{} && end == text.data() + text.size()) return code;
        throw InputError({path_, static_cast<int>(lines_ - 1), "group code", std::string(text)},
                         "is not a whole number", "save the drawing again as ASCII DXF");
    }

    const std::string& path_;
    std::ifstream stream_;
    long lines_ = 0;
};

struct CodedUnit {
    int code;
    const char* word;
};

constexpr std::array<CodedUnit, 6> coded_units = {
    {{1, "in"}, {2, "ft"}, {4, "mm"}, {5, "cm"}, {6, "m"}, {21, "us-ft"}}};

std::string unit_of(const Pair& insunits, const std::string& path) {
    const int code = integer_in(insunits.value);
    if (code == 0) return {};
    for (const CodedUnit& unit : coded_units)
        if (unit.code == code) return unit.word;
    throw InputError({path, static_cast<int>(insunits.line), "$INSUNITS", insunits.value},
                     "is a unit that no section is drawn in",
                     "draw it in metres, centimetres, millimetres, feet, US survey feet or inches");
}

void read_header(Pairs& pairs, const std::string& path, DxfOutline& outline) {
    std::string variable;
    while (const auto pair = pairs.next()) {
        if (pair->code == 0 && pair->value == "ENDSEC") return;
        if (pair->code == 9) variable = pair->value;
        if (pair->code != 70) continue;
        if (variable == "$INSUNITS") outline.unit = unit_of(*pair, path);
        if (variable == "$MEASUREMENT") outline.imperial = integer_in(pair->value) == 0;
    }
}

bool is_line(std::string_view type) {
    constexpr std::array<std::string_view, 6> types = {"LINE",   "LWPOLYLINE", "POLYLINE",
                                                       "SPLINE", "ARC",        "ELLIPSE"};
    for (const std::string_view line : types)
        if (type == line) return true;
    return false;
}

struct Entity {
    std::string type;
    std::string layer;
    bool paper = false;
    long control_points = 0;
    long line = 0;
};

void finish(const Entity& entity, const std::string& path, DxfOutline& outline) {
    if (entity.type == "SPLINE" && entity.control_points > most_control_points)
        throw InputError({path, static_cast<int>(entity.line), "SPLINE", ""},
                         fmt::format("has {} control points", entity.control_points),
                         fmt::format("turn it into a polyline; the limit is {}", most_control_points));
    if (is_line(entity.type) && !entity.paper) ++outline.lines_of_layer[entity.layer];
}

/// False: the file ends before the entities do.
bool read_entities(Pairs& pairs, const std::string& path, DxfOutline& outline) {
    Entity entity;
    while (const auto pair = pairs.next()) {
        if (pair->code == 0) {
            finish(entity, path, outline);
            if (pair->value == "ENDSEC") return true;
            entity = {pair->value, {}, false, 0, pair->line};
        }
        if (pair->code == 8) entity.layer = pair->value;
        if (pair->code == 67) entity.paper = pair->value == "1";
        if (pair->code == 10) ++entity.control_points;
    }
    return false;
}

}  // namespace

DxfOutline dxf_outline(const std::string& path) {
    Pairs pairs(path);
    DxfOutline outline;
    bool section_begins = false;
    while (const auto pair = pairs.next()) {
        if (section_begins && pair->code == 2 && pair->value == "HEADER") read_header(pairs, path, outline);
        if (section_begins && pair->code == 2 && pair->value == "ENTITIES") {
            if (read_entities(pairs, path, outline)) return outline;
            throw InputError({path, 0, "", ""}, "ends in the middle of its entities", "save it again, whole");
        }
        section_begins = pair->code == 0 && pair->value == "SECTION";
    }
    throw InputError({path, 0, "", ""}, "has no entities",
                     "give a drawing (ASCII DXF) with the ground as lines");
}

}  // namespace runout
