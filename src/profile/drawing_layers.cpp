#include "profile/drawing_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "core/input_error.h"
#include "core/words.h"

namespace runout {
namespace {

constexpr const char* key = "section.dxf_layers";
constexpr const char* shape = "write ground=NAME,source=NAME,slip=NAME, or the name of the ground alone";

// A message that lists more is not read.
constexpr std::size_t most_listed = 12;

struct Role {
    std::string_view name;
    std::string LayerRoles::*layer;
};

constexpr std::array<Role, 3> roles = {
    {{"ground", &LayerRoles::ground}, {"source", &LayerRoles::source}, {"slip", &LayerRoles::slip}}};

std::map<std::string, int> lines_by_layer(const Drawing& drawing) {
    std::map<std::string, int> counts;
    for (const DrawnLine& line : drawing.lines) ++counts[line.layer];
    return counts;
}

std::string list_of(const std::map<std::string, int>& layers) {
    std::string text;
    std::size_t listed = 0;
    for (const auto& [name, count] : layers) {
        if (listed++ == most_listed) return fmt::format("{} and {} more", text, layers.size() - most_listed);
        text += fmt::format("{}{} ({} line{})", text.empty() ? "" : ", ", name, count, count == 1 ? "" : "s");
    }
    return text;
}

/// The layer of that name; where none has it exactly, the one that differs in capitals alone.
std::string layer_named(const std::string& name, const std::map<std::string, int>& layers) {
    if (layers.contains(name)) return name;
    const auto found = std::ranges::find_if(
        layers, [&](const auto& layer) { return lower_case(layer.first) == lower_case(name); });
    return found == layers.end() ? "" : found->first;
}

const Role* role_of(std::string_view part) {
    for (const Role& role : roles)
        if (part.starts_with(role.name) && part.substr(role.name.size()).starts_with('=')) return &role;
    return nullptr;
}

/// "ground=A,B,slip=C": A,B is one name, since no role stands before B.
std::vector<std::string> parts_of(const std::string& option) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= option.size();) {
        const std::size_t end = std::min(option.find(',', begin), option.size());
        const std::string part = option.substr(begin, end - begin);
        if (parts.empty() || role_of(part) != nullptr)
            parts.push_back(part);
        else
            parts.back() += "," + part;
        begin = end + 1;
    }
    return parts;
}

LayerRoles named_roles(const Drawing& drawing, const std::string& option,
                       const std::map<std::string, int>& layers) {
    LayerRoles named;
    if (option.empty()) return named;
    for (const std::string& part : parts_of(option)) {
        const Role* role = role_of(part);
        const std::string name = role != nullptr ? part.substr(role->name.size() + 1) : part;
        std::string& layer = named.*(role != nullptr ? role->layer : &LayerRoles::ground);
        if (name.empty() || !layer.empty())
            throw InputError({drawing.file, 0, key, option},
                             name.empty() ? "names no layer" : "names two layers for one part", shape);
        layer = layer_named(name, layers);
        if (layer.empty())
            throw InputError({drawing.file, 0, key, option},
                             fmt::format("names the layer {}, which has no lines", name),
                             fmt::format("name of {}", list_of(layers)));
    }
    return named;
}

}  // namespace

LayerRoles layer_roles(const Drawing& drawing, const std::string& option) {
    const std::map<std::string, int> layers = lines_by_layer(drawing);
    if (layers.empty())
        throw InputError(
            {drawing.file, 0, "", ""}, "has no lines in its model space",
            "draw the ground as lines, polylines, arcs or splines, and explode blocks that hold it");
    LayerRoles found = named_roles(drawing, option, layers);
    std::map<std::string, int> others = layers;
    for (const Role& role : roles) {
        std::string& layer = found.*role.layer;
        if (layer.empty()) layer = layer_named(std::string(role.name), others);
        others.erase(layer);
    }
    if (found.ground.empty() && others.size() == 1) found.ground = others.begin()->first;
    if (found.ground.empty())
        throw InputError({drawing.file, 0, key, ""},
                         fmt::format("is missing, and the drawing has lines on {} layers", layers.size()),
                         fmt::format("give --layer ground=NAME, of {}", list_of(layers)));
    return found;
}

}  // namespace runout
