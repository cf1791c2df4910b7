#include <cpl_conv.h>
#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>

#include "gis/drawing.h"
#include "gis/drawn_geometry.h"
#include "gis/dxf_outline.h"
#include "gis/gdal_access.h"

namespace runout {
namespace {

// Texts and hatches make features too.
constexpr long most_entities = 500'000;

/// A setting of GDAL for this thread, for as long as this lives.
class GdalSetting {
  public:
    GdalSetting(const char* name, const char* value) : name_(name) {
        CPLSetThreadLocalConfigOption(name, value);
    }
    ~GdalSetting() { CPLSetThreadLocalConfigOption(name_, nullptr); }
    GdalSetting(const GdalSetting&) = delete;
    GdalSetting& operator=(const GdalSetting&) = delete;

  private:
    const char* name_;
};

GDALDatasetUniquePtr open_dxf(const std::string& path) {
    constexpr std::array<const char*, 2> drivers = {"DXF", nullptr};
    CPLErrorReset();
    GDALDatasetUniquePtr data(
        GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers.data()));
    if (data && data->GetLayerByName("entities") != nullptr) return data;
    throw InputError({path, 0, "", ""}, "is not a DXF that can be read" + gdal_reason(),
                     "save it as ASCII DXF, release 12 or 2000");
}

bool is_spline(const OGRFeature& feature) {
    return std::string_view(feature.GetFieldAsString("SubClasses")).find("AcDbSpline") !=
           std::string_view::npos;
}

/// What the pieces of a smooth curve leave out, from how much it turns at each of their ends.
double off_the_curve(const Polyline& points) {
    double farthest = 0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const Vec2 a = points[i] - points[i - 1];
        const Vec2 b = points[i + 1] - points[i];
        const double turn = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
        farthest = std::max(farthest, std::abs(turn) * std::max(a.norm(), b.norm()) / 8);
    }
    return farthest;
}

/// GDAL leaves out what it cannot read. On a layer of lines that would be a hole in the ground.
void check_complete(const DxfOutline& outline, const Drawing& drawing, const std::string& reason) {
    if (reason.empty()) return;
    long expected = 0;
    for (const auto& [layer, count] : outline.lines_of_layer) expected += count;
    if (static_cast<long>(drawing.lines.size()) >= expected) return;
    std::map<std::string, long> lines_read;
    for (const DrawnLine& line : drawing.lines) ++lines_read[line.layer];
    for (const auto& [layer, count] : outline.lines_of_layer)
        if (lines_read[layer] < count)
            throw InputError(
                {drawing.file, 0, "layer", layer},
                fmt::format("has {} lines, of which {} can be read{}", count, lines_read[layer], reason),
                "turn splines with fit points only, and what else is odd, into polylines");
}

}  // namespace

Drawing read_dxf(const std::string& path) {
    const DxfOutline outline = dxf_outline(path);
    const QuietGdal quiet;
    const GdalSetting blocks("DXF_INLINE_BLOCKS", "FALSE");
    const GdalSetting arcs("OGR_ARC_STEPSIZE", "1");
    const auto data = open_dxf(path);
    Drawing drawing{path, {}, outline.unit, "$INSUNITS", outline.imperial};
    DrawnPointCount count(path);
    CPLErrorReset();
    long entities = 0;
    for (const auto& feature : *data->GetLayerByName("entities")) {
        if (++entities > most_entities)
            throw InputError({path, 0, "", ""}, fmt::format("has more than {} entities", most_entities),
                             "keep the layers of the section alone");
        if (feature->GetFieldAsInteger("PaperSpace") != 0) continue;
        for (DrawnLine& line : drawn_lines(feature->GetGeometryRef(), count)) {
            line.layer = feature->GetFieldAsString("Layer");
            if (is_spline(*feature)) line.off_the_curve = off_the_curve(line.points);
            drawing.lines.push_back(std::move(line));
        }
    }
    check_complete(outline, drawing, CPLGetLastErrorType() >= CE_Failure ? gdal_reason() : "");
    return drawing;
}

}  // namespace runout
