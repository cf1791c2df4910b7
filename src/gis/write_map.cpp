#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "gis/gdal_access.h"
#include "gis/map_layers.h"
#include "gis/map_mark.h"
#include "gis/memory_file.h"

namespace runout {
namespace {

namespace fs = std::filesystem;

constexpr const char* output_option = "--output";
constexpr const char* wgs84 = "EPSG:4326";

enum class Format { geopackage, geojson };

Format format_of(const std::string& path) {
    const std::string ending = fs::path(path).extension().string();
    if (ending == ".gpkg") return Format::geopackage;
    if (ending == ".geojson" || ending == ".json") return Format::geojson;
    throw InputError({"", 0, output_option, path}, "is of no known format", "end it with .gpkg or .geojson");
}

[[noreturn]] void fail(const std::string& path) {
    throw InputError({path, 0, "", ""}, "cannot be written" + gdal_reason(),
                     "check permissions and free space");
}

bool is_nothing(const FieldValue& value) {
    const double* number = std::get_if<double>(&value);
    return std::holds_alternative<std::monostate>(value) || (number != nullptr && !std::isfinite(*number));
}

/// Real unless only whole numbers, or any text, stand in it.
OGRFieldType type_of(const FieldValue& value) {
    if (std::holds_alternative<std::string>(value)) return OFTString;
    return std::holds_alternative<long>(value) ? OFTInteger64 : OFTReal;
}

struct Field {
    std::string name;
    OGRFieldType type = OFTReal;
    bool seen = false;  ///< some feature has a value
};

std::vector<Field> fields_of(const MapLayer& layer) {
    std::vector<Field> fields;
    for (const MapFeature& feature : layer.features)
        for (const Attribute& attribute : feature.attributes) {
            auto field = std::ranges::find(fields, attribute.name, &Field::name);
            if (field == fields.end()) field = fields.insert(fields.end(), Field{attribute.name});
            if (is_nothing(attribute.value)) continue;
            const OGRFieldType type = type_of(attribute.value);
            if (!field->seen || type == OFTString)
                field->type = type;
            else if (field->type == OFTInteger64)
                field->type = type;
            field->seen = true;
        }
    return fields;
}

void create_fields(OGRLayer& target, const std::vector<Field>& fields, const std::string& path) {
    for (const Field& field : fields) {
        if (target.GetLayerDefn()->GetFieldIndex(field.name.c_str()) >= 0) continue;
        OGRFieldDefn definition(field.name.c_str(), field.type);
        if (target.CreateField(&definition) != OGRERR_NONE) fail(path);
    }
}

std::unique_ptr<OGRGeometry> geometry_of(GeometryKind kind, const Polyline& points,
                                         const Transformation& transformation) {
    if (points.empty()) return nullptr;  // it has values, and no place
    if (kind == GeometryKind::point) {
        const Vec2 at = transformation(points.front());
        return std::make_unique<OGRPoint>(at.x(), at.y());
    }
    std::unique_ptr<OGRLineString> chain(kind == GeometryKind::polygon ? new OGRLinearRing
                                                                       : new OGRLineString);
    for (const Vec2& point : points) {
        const Vec2 at = transformation(point);
        chain->addPoint(at.x(), at.y());
    }
    if (kind == GeometryKind::line) return chain;
    auto polygon = std::make_unique<OGRPolygon>();
    chain->closeRings();
    polygon->addRing(dynamic_cast<OGRLinearRing*>(chain.get()));
    return polygon;
}

void set_field(OGRFeature& feature, const Attribute& attribute) {
    if (is_nothing(attribute.value)) return;
    const char* name = attribute.name.c_str();
    if (const long* whole = std::get_if<long>(&attribute.value))
        feature.SetField(name, static_cast<GIntBig>(*whole));
    else if (const double* real = std::get_if<double>(&attribute.value))
        feature.SetField(name, *real);
    else
        feature.SetField(name, std::get<std::string>(attribute.value).c_str());
}

void write_features(OGRLayer& target, const MapLayer& layer, const Transformation& transformation,
                    const std::string& path) {
    const bool told_apart = target.GetLayerDefn()->GetFieldIndex("layer") >= 0;
    for (const MapFeature& mine : layer.features) {
        const OGRFeatureUniquePtr feature(OGRFeature::CreateFeature(target.GetLayerDefn()));
        if (told_apart) feature->SetField("layer", layer.name.c_str());
        for (const Attribute& attribute : mine.attributes) set_field(*feature, attribute);
        if (!mine.points.empty())
            feature->SetGeometryDirectly(geometry_of(layer.kind, mine.points, transformation).release());
        if (target.CreateFeature(feature.get()) != OGRERR_NONE) fail(path);
    }
}

OGRwkbGeometryType wkb_type(GeometryKind kind) {
    if (kind == GeometryKind::point) return wkbPoint;
    return kind == GeometryKind::line ? wkbLineString : wkbPolygon;
}

/// The table in which QGIS keeps the styles of a GeoPackage.
void write_styles(GDALDataset& data, const std::vector<MapLayer>& layers, const std::string& path) {
    const std::array<const char*, 2> options = {"ASPATIAL_VARIANT=GPKG_ATTRIBUTES", nullptr};
    OGRLayer* table = data.CreateLayer("layer_styles", nullptr, wkbNone, const_cast<char**>(options.data()));
    if (table == nullptr) fail(path);
    for (const char* name :
         {"f_table_catalog", "f_table_schema", "f_table_name", "f_geometry_column", "styleName", "styleQML",
          "styleSLD", "useAsDefault", "description", "owner", "ui", "update_time"}) {
        const std::string field = name;
        OGRFieldDefn definition(name, field == "useAsDefault"  ? OFTInteger
                                      : field == "update_time" ? OFTDateTime
                                                               : OFTString);
        if (field == "useAsDefault") definition.SetSubType(OFSTBoolean);
        if (table->CreateField(&definition) != OGRERR_NONE) fail(path);
    }
    for (const MapLayer& layer : layers) {
        if (layer.style.empty()) continue;
        const OGRFeatureUniquePtr row(OGRFeature::CreateFeature(table->GetLayerDefn()));
        row->SetField("f_table_catalog", "");
        row->SetField("f_table_schema", "");
        row->SetField("f_table_name", layer.name.c_str());
        row->SetField("f_geometry_column", "geom");
        row->SetField("styleName", layer.name.c_str());
        row->SetField("styleQML", layer.style.c_str());
        row->SetField("styleSLD", "");
        row->SetField("useAsDefault", 1);
        row->SetField("description", layer.title.c_str());
        row->SetField("owner", "");
        row->SetField("update_time", 2000, 1, 1, 0, 0, 0.0F, 100);  // the same file for the same runs
        if (table->CreateFeature(row.get()) != OGRERR_NONE) fail(path);
    }
}

void write_geopackage(GDALDataset& data, const MapSheet& sheet, const OGRSpatialReference& target,
                      const std::string& path) {
    const Transformation transformation(map_reference(reference_from(sheet.crs, "coordinate system")),
                                        target);
    OGRSpatialReference reference(target);
    for (const MapLayer& layer : sheet.layers) {
        const std::string identifier = "IDENTIFIER=" + layer.name;
        const std::string description = "DESCRIPTION=" + layer.title;
        const std::array<const char*, 4> options = {"GEOMETRY_NAME=geom", identifier.c_str(),
                                                    description.c_str(), nullptr};
        OGRLayer* written = data.CreateLayer(layer.name.c_str(), &reference, wkb_type(layer.kind),
                                             const_cast<char**>(options.data()));
        if (written == nullptr) fail(path);
        create_fields(*written, fields_of(layer), path);
        if (written->StartTransaction() != OGRERR_NONE) fail(path);
        write_features(*written, layer, transformation, path);
        if (written->CommitTransaction() != OGRERR_NONE) fail(path);
    }
    write_styles(data, sheet.layers, path);
}

void write_geojson(GDALDataset& data, const MapSheet& sheet, const std::string& path) {
    OGRSpatialReference reference = reference_from(wgs84, "coordinate system");
    const Transformation transformation(map_reference(reference_from(sheet.crs, "coordinate system")),
                                        reference);
    // Nine decimals of a degree are a tenth of a millimetre.
    const std::array<const char*, 3> options = {"RFC7946=YES", "COORDINATE_PRECISION=9", nullptr};
    OGRLayer* written =
        data.CreateLayer("runout", &reference, wkbUnknown, const_cast<char**>(options.data()));
    if (written == nullptr) fail(path);
    create_fields(*written, {{"layer", OFTString, true}}, path);
    for (const MapLayer& layer : sheet.layers) create_fields(*written, fields_of(layer), path);
    for (const MapLayer& layer : sheet.layers) write_features(*written, layer, transformation, path);
}

void write_to(const std::string& path, const MapSheet& sheet, const std::string& target_crs) {
    const bool geopackage = format_of(path) == Format::geopackage;
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(geopackage ? "GPKG" : "GeoJSON");
    if (driver == nullptr)
        throw InputError({"", 0, output_option, path}, "needs a driver that this GDAL lacks",
                         "install GDAL with GPKG and GeoJSON");
    CPLErrorReset();
    const GDALDatasetUniquePtr data(driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    if (!data) fail(path);
    if (geopackage)
        write_geopackage(*data, sheet,
                         map_reference(reference_from(target_crs.empty() ? sheet.crs : target_crs, "--crs")),
                         path);
    else
        write_geojson(*data, sheet, path);
    CPLErrorReset();
    data->FlushCache();
    if (CPLGetLastErrorType() >= CE_Failure) fail(path);
}

/// Another program that has a GeoPackage open keeps what it has written in a file beside it. A new GeoPackage
/// of that name would take that for its own.
void refuse_open_geopackage(const std::string& path) {
    std::error_code ignored;
    const fs::path place = fs::weakly_canonical(fs::absolute(path), ignored);
    for (const char* ending : {"-wal", "-journal"}) {
        const std::string beside = place.string() + ending;
        if (fs::exists(beside, ignored))
            throw InputError({"", 0, output_option, path}, "is in use: " + beside + " lies beside it",
                             "close the program that has it open; if none has, remove that file");
    }
}

OutputRules map_rules(OutputRules rules) {
    rules.is_own_output = is_unedited_map;
    return rules;
}

}  // namespace

void check_map_path(const std::string& path, const std::string& target_crs, const OutputRules& rules) {
    const QuietGdal quiet;
    const Format format = format_of(path);
    if (!target_crs.empty()) {
        if (format == Format::geojson)
            throw InputError({"", 0, "--crs", target_crs},
                             "does not apply to GeoJSON, which is always in WGS 84",
                             "leave it out, or write a .gpkg");
        reference_from(target_crs, "--crs");
    }
    if (format == Format::geopackage) refuse_open_geopackage(path);
    check_output_place(path, output_option, Folder::exists, map_rules(rules));
}

void write_map(const std::string& path, const MapSheet& sheet, const std::string& target_crs,
               const OutputRules& rules) {
    check_map_path(path, target_crs, rules);
    const QuietGdal quiet;
    MapSheet filled{sheet.crs, {}};
    for (const MapLayer& layer : sheet.layers)
        if (!layer.features.empty()) filled.layers.push_back(layer);
    const MemoryFile file(fs::path(path).extension().string());
    write_to(file.path(), filled, target_crs);
    const bool geopackage = format_of(path) == Format::geopackage;
    const std::string map = geopackage ? with_map_mark(file.bytes(), path) : file.bytes();
    if (geopackage) refuse_open_geopackage(path);  // opened while the work went on
    write_output_file(path, output_option, map, map_rules(rules));
}

}  // namespace runout
