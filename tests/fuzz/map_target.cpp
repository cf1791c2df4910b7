#include <array>
#include <filesystem>

#include "fuzz/bytes.h"
#include "fuzz/targets.h"
#include "gis/map_layers.h"

namespace runout::fuzz {
namespace {

FieldValue value_from(Numbers& numbers) {
    switch (numbers.byte() % 4) {
        case 0:
            return numbers.number();
        case 1:
            return static_cast<long>(numbers.byte()) << (numbers.byte() % 56);
        case 2:
            return numbers.text();
        default:
            return std::monostate{};
    }
}

MapFeature feature_from(Numbers& numbers) {
    MapFeature feature;
    for (int left = numbers.byte() % 8; left > 0; --left) {
        const double x = numbers.number();
        feature.points.emplace_back(x, numbers.number());
    }
    for (int left = numbers.byte() % 4; left > 0; --left) {
        const std::string name = numbers.text();
        feature.attributes.push_back({name, value_from(numbers)});
    }
    return feature;
}

MapLayer layer_from(Numbers& numbers) {
    MapLayer layer;
    layer.name = numbers.text();
    layer.title = numbers.text();
    layer.kind = static_cast<GeometryKind>(numbers.byte() % 3);
    layer.style = numbers.text();
    for (int left = 1 + numbers.byte() % 3; left > 0; --left) layer.features.push_back(feature_from(numbers));
    return layer;
}

std::string system_from(Numbers& numbers) {
    constexpr std::array known = {"EPSG:2326", "EPSG:4326", "EPSG:3857", "EPSG:2276", ""};
    const std::size_t choice = numbers.byte() % (known.size() + 1);
    return choice < known.size() ? known[choice] : numbers.text();
}

}  // namespace

void write_any_map(std::span<const std::uint8_t> bytes) {
    Numbers numbers(bytes);
    const bool geopackage = numbers.byte() % 4 == 0;  // it takes longest
    const std::string path = written({}, geopackage ? ".gpkg" : ".geojson");
    std::filesystem::remove(path);
    MapSheet sheet{system_from(numbers), {}};
    const std::string target = geopackage ? system_from(numbers) : "";
    for (int left = 1 + numbers.byte() % 3; left > 0; --left) sheet.layers.push_back(layer_from(numbers));
    accept_input_error([&] {
        write_map(path, sheet, target);
        require(std::filesystem::exists(path), "a map that was written is there");
        std::filesystem::remove(path);
    });
    require(!std::filesystem::exists(path), "a map that is refused is not there");
}

}  // namespace runout::fuzz
