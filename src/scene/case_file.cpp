#include "scene/case_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/words.h"
#include "profile/section_file.h"
#include "scene/parameters.h"
#include "scene/toml_reading.h"

namespace runout {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_entries = 1000;  // of [[place]] and the like
constexpr std::size_t longest_quoted = 60;  // of a key or a value, in a message

InputPlace whole_file(const std::string& path) {
    return {.file = path, .line = 0, .key = {}, .value = {}};
}

std::string read_text(const std::string& path) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored))
        throw InputError(whole_file(path), "is a folder", "give the case file in it, such as case.toml");
    return read_toml_text(path, "give a case (.toml) or a section (.csv)");
}

/// "box-45" for cases/box-45/case.toml, "cut-60" for profiles/cut-60.csv.
std::string name_from(const std::string& path) {
    const fs::path full = fs::absolute(path).lexically_normal();
    return full.stem() == "case" ? full.parent_path().filename().string() : full.stem().string();
}

std::string shortened(std::string text, std::size_t longest) {
    if (text.size() > longest) text = text.substr(0, longest) + "...";
    return text;
}

/// A text whose lines are found at once.
class WrittenText {
  public:
    explicit WrittenText(std::string_view text) : text_(text) {
        for (std::size_t i = 0; i < text.size(); ++i)
            if (text[i] == '\n') starts_.push_back(i + 1);
    }

    /// The characters that make up a value, as the user wrote them, shortened.
    [[nodiscard]] std::string value(const toml::source_region& region) const {
        if (region.begin.line == 0 || region.begin.line > starts_.size()) return {};
        const std::size_t start = starts_[region.begin.line - 1];
        const std::string_view line = text_.substr(start, text_.find('\n', start) - start);
        if (region.begin.column == 0 || region.begin.column > line.size()) return {};
        const bool one_line = region.end.line == region.begin.line && region.end.column > region.begin.column;
        std::string value(line.substr(region.begin.column - 1,
                                      one_line ? region.end.column - region.begin.column : line.npos));
        while (!value.empty() && (std::isspace(static_cast<unsigned char>(value.back())) != 0))
            value.pop_back();
        return shortened(value, longest_quoted);
    }

  private:
    std::string_view text_;
    std::vector<std::size_t> starts_ = {0};
};

std::optional<Vec2> point_from(const toml::node& node) {
    const toml::array* pair = node.as_array();
    if (pair == nullptr || pair->size() != 2) return std::nullopt;
    const std::optional<double> x = number_in((*pair)[0]);
    const std::optional<double> y = number_in((*pair)[1]);
    if (!x || !y) return std::nullopt;
    return Vec2(*x, *y);
}

Vec2 place_from(const toml::node& node, const Parameter& parameter, const InputPlace& place) {
    const std::optional<Vec2> point = point_from(node);
    if (!point) throw InputError(place, "is not a pair of numbers", "valid: " + valid_values(parameter));
    return *point;
}

Polyline points_from(const toml::node& node, const Parameter& parameter, const InputPlace& place) {
    const toml::array* list = node.as_array();
    if (list == nullptr) throw InputError(place, "is not a list", "valid: " + valid_values(parameter));
    Polyline points;
    for (const toml::node& entry : *list) {
        const std::optional<Vec2> point = point_from(entry);
        if (!point)
            throw InputError(place,
                             fmt::format("has an entry {} that is not a pair of numbers", points.size() + 1),
                             "valid: " + valid_values(parameter));
        points.push_back(*point);
    }
    return points;
}

std::vector<double> numbers_from(const toml::node& node, const Parameter& parameter,
                                 const InputPlace& place) {
    const toml::array* list = node.as_array();
    if (list == nullptr) throw InputError(place, "is not a list", "valid: " + valid_values(parameter));
    std::vector<double> numbers;
    for (const toml::node& entry : *list) {
        const std::optional<double> number = number_in(entry);
        if (!number)
            throw InputError(place, fmt::format("has an entry {} that is not a number", numbers.size() + 1),
                             "valid: " + valid_values(parameter));
        numbers.push_back(*number);
    }
    return numbers;
}

std::vector<double> row_from(const toml::node& node) {
    std::vector<double> row;
    const toml::array* list = node.as_array();
    if (list == nullptr) return row;
    for (const toml::node& entry : *list) row.push_back(number_in(entry).value_or(std::nan("")));
    return row;
}

NumberRows rows_from(const toml::node& node, const Parameter& parameter, const InputPlace& place) {
    const toml::array* list = node.as_array();
    if (list == nullptr) throw InputError(place, "is not a list", "valid: " + valid_values(parameter));
    NumberRows rows;
    for (const toml::node& entry : *list) rows.push_back(row_from(entry));
    return rows;
}

/// A value of a kind that is written in brackets.
Value list_from(const toml::node& node, const Parameter& parameter, const InputPlace& place) {
    if (parameter.kind == ValueKind::rows) return rows_from(node, parameter, place);
    if (parameter.kind == ValueKind::place) return place_from(node, parameter, place);
    if (parameter.kind == ValueKind::points) return points_from(node, parameter, place);
    return numbers_from(node, parameter, place);
}

Value value_from(const toml::node& node, const Parameter& parameter, const InputPlace& place) {
    switch (parameter.kind) {
        case ValueKind::place:
        case ValueKind::points:
        case ValueKind::numbers:
        case ValueKind::rows:
            return list_from(node, parameter, place);
        case ValueKind::text:
        case ValueKind::choice:
            if (!node.is_string())
                throw InputError(place, "is not a text in quotes", "valid: " + valid_values(parameter));
            return node.ref<std::string>();
        case ValueKind::integer:
        case ValueKind::number:
            break;
    }
    const std::optional<double> number = number_in(node);
    if (!number) throw InputError(place, "is not a number", "valid: " + valid_values(parameter));
    return *number;
}

double number_from(const std::string& text, const Parameter& parameter, const InputPlace& place) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size())
        throw InputError(place, "is not a number", "valid: " + valid_values(parameter));
    return value;
}

/// A table with the key "list" and nothing else.
toml::table parsed_list(const std::string& text, const Parameter& parameter, const InputPlace& place) {
    const InputError refusal(place, "is not a list", "valid: " + valid_values(parameter));
    try {
        toml::table parsed = parse_toml("list = " + text, "");
        if (parsed.size() == 1) return parsed;
    } catch (const InputError&) {
        throw refusal;
    }
    throw refusal;
}

Value value_from(const std::string& text, const Parameter& parameter, const InputPlace& place) {
    switch (parameter.kind) {
        case ValueKind::integer:
        case ValueKind::number:
            return number_from(text, parameter, place);
        case ValueKind::text:
        case ValueKind::choice:
            return text;
        case ValueKind::place:
        case ValueKind::points:
        case ValueKind::numbers:
        case ValueKind::rows:
            break;
    }
    // On a command line the brackets around one place say nothing.
    const bool bare = parameter.kind == ValueKind::place && !text.starts_with('[');
    const toml::table parsed = parsed_list(bare ? "[" + text + "]" : text, parameter, place);
    return list_from(*parsed.get("list"), parameter, place);
}

/// [[gauge]] is what [[place]] was called before.
std::string present_name(std::string name) {
    if (name == "gauge" || name.starts_with("gauge.")) name.replace(0, 5, "place");
    return name;
}

bool is_section(std::string_view name) {
    return std::ranges::any_of(parameters(), [&](const Parameter& parameter) {
        return parameter.key.starts_with(fmt::format("{}.", name));
    });
}

/// Reads the keys of a parsed file, and keeps what error messages need.
class CaseReader {
  public:
    CaseReader(CaseSpec& spec, const std::string& text) : spec_(spec), text_(text) {}

    void read(const toml::table& root) {
        for (const auto& [key, node] : root) {
            const std::string name = present_name(std::string(key.str()));
            check_is_one_word(key, place(name, key, node));
            if (!is_section(name) || !read_if_section(name, node))
                throw unknown_key(first_place(name, key, node));
        }
    }

  private:
    /// TOML takes "a.b" in quotes for another key than a.b, so that one thing could be said twice.
    static void check_is_one_word(const toml::key& key, const InputPlace& place) {
        if (key.str().find('.') == std::string_view::npos) return;
        throw InputError(place, "is a dotted key in quotes", "write it without the quotes");
    }

    /// Reads [name], or each [[name]] where a section may stand several times. False: it is neither.
    bool read_if_section(const std::string& name, const toml::node& node) {
        if (const toml::table* table = node.as_table()) {
            if (is_list_section(name)) begin_entry(spec_, name);
            read_section(name, *table);
            return true;
        }
        const toml::array* entries = node.as_array();
        if (entries == nullptr || !entries->is_homogeneous(toml::node_type::table)) return false;
        if (!is_list_section(name))
            throw InputError({spec_.file, static_cast<int>(node.source().begin.line), name, {}},
                             "stands several times", fmt::format("write [{}], once", name));
        if (entries->size() > most_entries)
            throw InputError({spec_.file, static_cast<int>(node.source().begin.line), name, {}},
                             fmt::format("stands {} times", entries->size()),
                             fmt::format("write [[{}]] at most {} times", name, most_entries));
        for (const toml::node& entry : *entries) {
            begin_entry(spec_, name);
            read_section(name, *entry.as_table());
        }
        return true;
    }

    void read_section(const std::string& section, const toml::table& table) {
        if (table.empty() && section.starts_with("effects."))
            throw InputError({spec_.file, static_cast<int>(table.source().begin.line), section, {}},
                             "is named without a key", "give its keys (runout help keys), or leave it out");
        for (const auto& [key, node] : table) {
            const InputPlace at = place(fmt::format("{}.{}", section, key.str()), key, node);
            check_is_one_word(key, at);
            if (is_section(at.key) && read_if_section(at.key, node)) continue;
            const Parameter& parameter = known_parameter(at);
            assign(spec_, parameter, value_from(node, parameter, at), at);
        }
    }

    /// Of a section that does not exist, its first key tells best what was meant.
    [[nodiscard]] InputPlace first_place(const std::string& name, const toml::key& key,
                                         const toml::node& node) const {
        const toml::table* table = node.as_table();
        if (table == nullptr || table->empty()) return place(name, key, node);
        const auto [first, value] = *table->begin();
        return place(fmt::format("{}.{}", name, first.str()), first, value);
    }

    [[nodiscard]] InputPlace place(std::string name, const toml::key& key, const toml::node& node) const {
        return {.file = spec_.file,
                .line = static_cast<int>(key.source().begin.line),
                .key = shortened(std::move(name), longest_quoted),
                .value = node.is_table() ? "" : text_.value(node.source())};
    }

    CaseSpec& spec_;
    WrittenText text_;
};

/// Paths in a case file start at the case file, so that a case can be run from anywhere.
void resolve_paths(CaseSpec& spec) {
    const fs::path folder = fs::path(spec.file).parent_path();
    SectionSpec& section = spec.section;
    for (std::string* path : {&section.file, &section.map.raster, &section.map.line.file,
                              &spec.map_places.file, &spec.shaking_record})
        if (!path->empty()) *path = (folder / *path).lexically_normal().string();
}

void read_toml(CaseSpec& spec) {
    const std::string text = read_text(spec.file);
    if (text.find_first_not_of(" \t\r\n") == std::string::npos)
        throw InputError(whole_file(spec.file), "is empty",
                         "a case has [section], [source], [material] and [run]");
    CaseReader(spec, text).read(parse_toml(text, spec.file));
    resolve_paths(spec);
}

// Three ways to say how fine a run is. The command line's word replaces the file's, in whatever way that said
// it.
constexpr std::array<std::string_view, 3> ways_to_say_how_fine = {"run.accuracy", "run.resolution",
                                                                  "run.particle_spacing_m"};

bool says_how_fine(std::string_view key) {
    return std::ranges::find(ways_to_say_how_fine, key) != ways_to_say_how_fine.end();
}

void forget_how_fine_the_file_said(CaseSpec& spec, std::string_view except) {
    const CaseSpec fresh;
    for (const std::string_view key : ways_to_say_how_fine) {
        const auto given = spec.given.find(key);
        if (key == except || given == spec.given.end() || given->second.file != spec.file) continue;
        spec.given.erase(given);
        if (key == "run.accuracy") spec.accuracy = fresh.accuracy;
        if (key == "run.resolution") spec.run.resolution = fresh.run.resolution;
        if (key == "run.particle_spacing_m") spec.run.particle_spacing = fresh.run.particle_spacing;
    }
}

/// "a drawing (DXF) as .dxf; LandXML as .xml, .landxml; ": what a section of its own may be.
std::string formats_with_endings() {
    std::string list;
    for (const SectionFormat& format : section_formats())
        if (!format.endings.empty())
            list += fmt::format("{} as {}; ", format.name, fmt::join(format.endings, ", "));
    return list;
}

/// Which key a file stands for that is no case; empty if none. What has the ending of a table, a drawing or
/// LandXML is one, and never taken for a map; a drawing in DXF is a map only as section.line.
std::string section_key(const std::string& path) {
    const std::string ending = lower_ending(path);
    for (const SectionFormat& format : section_formats())
        if (std::ranges::find(format.endings, ending) != format.endings.end()) return "section.file";
    const std::string driver = line_driver(path);
    return driver.empty() || driver == "DXF" ? "" : "section.line";
}

}  // namespace

CaseSpec read_case(const std::string& path) {
    CaseSpec spec;
    spec.file = path;
    if (lower_ending(path) == ".toml") {
        read_toml(spec);
    } else if (const std::string key = section_key(path); !key.empty()) {
        const InputPlace place{.file = path, .line = 0, .key = key, .value = {}};
        assign(spec, known_parameter(place), path, place);
    } else {
        read_text(path);  // a missing file is the likelier mistake, and says so
        throw InputError(whole_file(path), "is neither a case nor a section",
                         fmt::format("give a .toml file; {}or lines as GeoPackage, shapefile, GeoJSON, KML, "
                                     "GPX and the like (docs/maps.md)",
                                     formats_with_endings()));
    }
    if (!spec.has("run.name")) spec.name = name_from(path);
    return spec;
}

void override_value(CaseSpec& spec, const std::string& asked, const std::string& text,
                    const std::string& option) {
    const std::string key = present_name(asked);
    const InputPlace place{.file = option, .line = 0, .key = key, .value = text};
    const Parameter& parameter = known_parameter(place);
    assign(spec, parameter, value_from(text, parameter, place), place);
    if (says_how_fine(key)) forget_how_fine_the_file_said(spec, key);
}

}  // namespace runout
