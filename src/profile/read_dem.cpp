#include <cpl_error.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_geometry.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/input_error.h"
#include "profile/profile.h"

namespace runout {
namespace {

/// GDAL reports through return values here, not on standard error as well.
class QuietGdal {
  public:
    QuietGdal() { CPLPushErrorHandler(CPLQuietErrorHandler); }
    ~QuietGdal() { CPLPopErrorHandler(); }
    QuietGdal(const QuietGdal&) = delete;
    QuietGdal& operator=(const QuietGdal&) = delete;
};

GDALDatasetUniquePtr open_dataset(const std::string& path, unsigned kind, const std::string& valid) {
    CPLErrorReset();
    GDALDatasetUniquePtr data(GDALDataset::Open(path.c_str(), kind | GDAL_OF_READONLY));
    if (data) return data;
    const std::string reason = CPLGetLastErrorMsg();
    throw InputError({path, 0, "", ""},
                     reason.empty() ? "cannot be opened" : "cannot be opened (" + reason + ")", valid);
}

/// The ground as the raster has it: elevation at any point inside its edge.
class Raster {
  public:
    explicit Raster(const std::string& path)
        : path_(path),
          data_(open_dataset(path, GDAL_OF_RASTER, "give an elevation raster that GDAL can read")) {
        band_ = data_->GetRasterCount() > 0 ? data_->GetRasterBand(1) : nullptr;
        if (band_ == nullptr)
            throw InputError({path, 0, "", ""}, "has no band", "give a raster with elevations");
        if (data_->GetGeoTransform(to_map_.data()) != CE_None ||
            GDALInvGeoTransform(to_map_.data(), to_cell_.data()) == 0)
            throw InputError({path, 0, "", ""}, "is not placed on a map",
                             "give a raster with a geotransform");
        if (reference() != nullptr && reference()->IsGeographic() != 0)
            throw InputError({path, 0, "", ""}, "has its coordinates in degrees",
                             "project it to metres first, with gdalwarp -t_srs");
    }

    [[nodiscard]] const OGRSpatialReference* reference() const { return data_->GetSpatialRef(); }

    /// Metres in a unit of the map.
    [[nodiscard]] double metres() const {
        return reference() != nullptr ? reference()->GetLinearUnits() : 1.0;
    }

    [[nodiscard]] double cell_size_m() const {
        return metres() * std::sqrt(std::abs(to_map_[1] * to_map_[5] - to_map_[2] * to_map_[4]));
    }

    [[nodiscard]] double elevation(const Vec2& map) const {
        const double column = to_cell_[0] + to_cell_[1] * map.x() + to_cell_[2] * map.y();
        const double row = to_cell_[3] + to_cell_[4] * map.x() + to_cell_[5] * map.y();
        if (column < 0 || row < 0 || column > band_->GetXSize() || row > band_->GetYSize())
            refuse(map, "lies outside the raster", "shorten the line or take a larger raster");
        // Values belong to cell centres; within half a cell of the edge the outermost value holds.
        const double x = std::clamp(column - 0.5, 0.0, band_->GetXSize() - 1.0);
        const double y = std::clamp(row - 0.5, 0.0, band_->GetYSize() - 1.0);
        return bilinear(x, y, map);
    }

  private:
    [[noreturn]] void refuse(const Vec2& map, const std::string& problem, const std::string& valid) const {
        throw InputError({path_, 0, "section line", fmt::format("({:.3f}, {:.3f})", map.x(), map.y())},
                         problem, valid);
    }

    [[nodiscard]] double bilinear(double x, double y, const Vec2& map) const {
        const int column = static_cast<int>(x);
        const int row = static_cast<int>(y);
        const double u = x - column;
        const double v = y - row;
        double sum = 0;
        // A cell without weight is not read: it may lie beyond the edge or hold no data.
        if (u < 1 && v < 1) sum += (1 - u) * (1 - v) * value(column, row, map);
        if (u > 0) sum += u * (1 - v) * value(column + 1, row, map);
        if (v > 0) sum += (1 - u) * v * value(column, row + 1, map);
        if (u > 0 && v > 0) sum += u * v * value(column + 1, row + 1, map);
        return sum;
    }

    [[nodiscard]] double value(int column, int row, const Vec2& map) const {
        double z = 0;
        if (band_->RasterIO(GF_Read, column, row, 1, 1, &z, 1, 1, GDT_Float64, 0, 0, nullptr) != CE_None)
            refuse(map, "cannot be read from the raster", "check that the file is whole");
        int has_no_data = 0;
        const double no_data = band_->GetNoDataValue(&has_no_data);
        if (!std::isfinite(z) || (has_no_data != 0 && z == no_data))
            refuse(map, "crosses a cell without data",
                   "fill the gap, for example with gdal_fillnodata.py, or move the line");
        return band_->GetOffset() + band_->GetScale() * z;
    }

    std::string path_;
    GDALDatasetUniquePtr data_;
    GDALRasterBand* band_ = nullptr;
    std::array<double, 6> to_map_{};
    std::array<double, 6> to_cell_{};
};

void bring_to(const OGRSpatialReference* target, OGRLineString& line, const std::string& path) {
    const OGRSpatialReference* own = line.getSpatialReference();
    if (target == nullptr || own == nullptr || own->IsSame(target) != 0) return;
    OGRSpatialReference from(*own);
    OGRSpatialReference to(*target);
    from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    to.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRCoordinateTransformation> transformation(
        OGRCreateCoordinateTransformation(&from, &to));
    if (!transformation || line.transform(transformation.get()) != OGRERR_NONE)
        throw InputError({path, 0, "", ""}, "cannot be brought to the coordinate system of the raster",
                         "give the line in that system");
}

/// The line of the first feature; a multi-line of one part is a line.
const OGRLineString* line_of(const OGRGeometry* geometry) {
    if (geometry == nullptr) return nullptr;
    const auto kind = wkbFlatten(geometry->getGeometryType());
    if (kind == wkbLineString) return geometry->toLineString();
    if (kind == wkbMultiLineString && geometry->toMultiLineString()->getNumGeometries() == 1)
        return line_of(geometry->toMultiLineString()->getGeometryRef(0));
    return nullptr;
}

OGRLineString read_line(const std::string& path, const OGRSpatialReference* target) {
    const auto data =
        open_dataset(path, GDAL_OF_VECTOR, "give a vector file that GDAL can read, with one line");
    OGRLayer* layer = data->GetLayerCount() > 0 ? data->GetLayer(0) : nullptr;
    const OGRFeatureUniquePtr feature(layer != nullptr ? layer->GetNextFeature() : nullptr);
    if (!feature) throw InputError({path, 0, "", ""}, "has no feature", "draw the section as one line");
    const OGRGeometry* geometry = feature->GetGeometryRef();
    const OGRLineString* found = line_of(geometry);
    if (found == nullptr)
        throw InputError({path, 0, "geometry", geometry != nullptr ? geometry->getGeometryName() : "none"},
                         "is not a line", "draw the section as one LineString");
    OGRLineString line(*found);
    bring_to(target, line, path);
    if (line.getNumPoints() < 2 || !(line.get_Length() > 0))
        throw InputError({path, 0, "geometry", "LINESTRING"}, "has no length", "give it two points or more");
    return line;
}

/// Evenly spaced from end to end, no farther apart than `spacing_m`.
std::vector<Vec2> sample(const Raster& raster, const OGRLineString& line, double spacing_m) {
    const double length = line.get_Length();
    const auto steps = std::max(1, static_cast<int>(std::ceil(length * raster.metres() / spacing_m - 1e-9)));
    std::vector<Vec2> points;
    for (int i = 0; i <= steps; ++i) {
        const double along = length * i / steps;
        OGRPoint at;
        line.Value(along, &at);
        points.emplace_back(along * raster.metres(), raster.elevation({at.getX(), at.getY()}));
    }
    return points;
}

}  // namespace

Profile read_profile_dem(const DemLine& dem, const ProfileOptions& options) {
    if (!(dem.sampling_m >= 0) || !std::isfinite(dem.sampling_m))
        throw InputError({"", 0, "section.sampling_m", fmt::format("{:g}", dem.sampling_m)},
                         "is not a distance", "give metres, or 0 for half a raster cell");
    const QuietGdal quiet;
    GDALAllRegister();
    const Raster raster(dem.raster);
    const OGRLineString line = read_line(dem.line, raster.reference());
    const double spacing = dem.sampling_m > 0 ? dem.sampling_m : raster.cell_size_m() / 2;
    return make_profile(sample(raster, line, spacing), {}, fmt::format("{} along {}", dem.raster, dem.line),
                        options);
}

}  // namespace runout
