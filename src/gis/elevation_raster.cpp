#include "gis/elevation_raster.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/elevation_limits.h"
#include "core/length_unit.h"
#include "gis/gdal_access.h"
#include "gis/raster_cells.h"

namespace runout {
namespace {

constexpr double foot_m = length_unit("ft")->metres;
constexpr double us_survey_foot_m = length_unit("us-ft")->metres;
constexpr double smallest_cell_m = 1e-6;
constexpr double unit_tolerance = 1e-4;  // as labels are rounded, no further than a metre is from a metre

/// Shares of four neighbouring cells in a value between the second and the third, 0 <= t < 1.
using Weights = std::array<double, 4>;

Weights weights(Interpolation interpolation, double t) {
    if (interpolation == Interpolation::bilinear) return {0, 1 - t, t, 0};
    return {t * (-0.5 + t * (1 - 0.5 * t)), 1 + t * t * (-2.5 + 1.5 * t), t * (0.5 + t * (2 - 1.5 * t)),
            t * t * (-0.5 + 0.5 * t)};
}

/// The cells around a place, from one before (column, row) to two after, and their shares.
struct Footprint {
    int column = 0;
    int row = 0;
    Weights across{};
    Weights down{};
};

/// Metres in the unit that a band names; 0 when it names none that is known.
double unit_of_label(const std::string& label) {
    std::string word = label;
    std::ranges::transform(word, word.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (word == "m" || word.starts_with("met")) return 1;
    if (word.starts_with("us") || word == "ftus") return us_survey_foot_m;
    if (word == "ft" || word.starts_with("foot") || word.starts_with("feet") ||
        word.starts_with("international f"))
        return foot_m;
    return 0;
}

}  // namespace

double unit_m(const std::string& unit) {
    return unit.empty() ? 1.0 : known_length_unit(unit).metres;
}

void refuse_unconfirmed_unit(const std::string& file, double stated_m) {
    if (stated_m == 0 || std::abs(stated_m - 1) < unit_tolerance) return;
    throw InputError(
        {file, 0, "", ""}, fmt::format("counts in units of {:.7g} m, not in metres", stated_m),
        "confirm it with section.elevation_unit = \"ft\" or \"us-ft\", or say \"m\" if the elevations "
        "are metres all the same");
}

struct ElevationRaster::Impl {
    std::string path;
    RasterOptions options;
    GDALDatasetUniquePtr data;
    GDALRasterBand* band = nullptr;
    OGRSpatialReference reference;
    double to_metres = 1;
    std::array<double, 6> to_map{};
    std::array<double, 6> to_cell{};

    Impl(const std::string& file, const RasterOptions& given)
        : path(file),
          options(given),
          data(open_dataset(file, GDAL_OF_RASTER, "give an elevation raster that GDAL can read")) {
        band = data->GetRasterCount() > 0 ? data->GetRasterBand(1) : nullptr;
        if (band == nullptr) refuse("has no band", "give a raster with elevations");
        if (data->GetGeoTransform(to_map.data()) != CE_None ||
            GDALInvGeoTransform(to_map.data(), to_cell.data()) == 0)
            refuse("is not placed on a map", "give a raster with a geotransform");
        set_reference_and_unit();
    }

    [[noreturn]] void refuse(const std::string& problem, const std::string& valid) const {
        throw InputError({path, 0, "", ""}, problem, valid);
    }

    void set_reference_and_unit() {
        const OGRSpatialReference* own = data->GetSpatialRef();
        if (own == nullptr && options.crs.empty())
            refuse("names no coordinate system", "give section.raster_crs, such as EPSG:2326");
        const OGRSpatialReference whole =
            options.crs.empty() ? *own : reference_from(options.crs, "section.raster_crs");
        reference = map_reference(whole);
        to_metres = unit_m(options.elevation_unit);
        if (!options.elevation_unit.empty()) return;
        double stated = unit_of_label(band->GetUnitType());
        if (stated == 0) stated = vertical_unit_m(whole);
        // Nothing is said of heights: who surveys in feet has them in feet as well.
        if (stated == 0 && reference.IsProjected() != 0) stated = reference.GetLinearUnits();
        refuse_unconfirmed_unit(path, stated);
    }

    [[nodiscard]] Transformation from_line(const MapLine& line) const {
        Transformation transformation(map_reference(reference_from(line.crs, "section.line")), reference);
        if (!transformation.exists())
            refuse(fmt::format("cannot be reached from the coordinate system of the line{}", gdal_reason()),
                   "give the line in the system of the raster");
        return transformation;
    }

    [[nodiscard]] Vec2 cell_of(const Vec2& map) const {
        return {to_cell[0] + to_cell[1] * map.x() + to_cell[2] * map.y(),
                to_cell[3] + to_cell[4] * map.x() + to_cell[5] * map.y()};
    }

    /// The cells about a place. Throws InputError when it lies outside.
    [[nodiscard]] Footprint footprint(const Vec2& map, const InputPlace& place) const {
        const Vec2 cell = cell_of(map);
        const double columns = band->GetXSize();
        const double rows = band->GetYSize();
        if (!(cell.x() >= 0 && cell.y() >= 0 && cell.x() <= columns && cell.y() <= rows))
            throw InputError(place, "lies outside the raster", "shorten the line or take a larger raster");
        const double x = std::clamp(cell.x() - 0.5, 0.0, columns - 1);
        const double y = std::clamp(cell.y() - 0.5, 0.0, rows - 1);
        const int column = static_cast<int>(x);
        const int row = static_cast<int>(y);
        return {column, row, weights(options.interpolation, x - column),
                weights(options.interpolation, y - row)};
    }

    /// Calls take(column, row, weight) for each cell that counts. Beyond the edge the outermost cells go on.
    template <class Take>
    void for_cells(const Footprint& footprint, const Take& take) const {
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i) {
                const double weight = footprint.across[i] * footprint.down[j];
                if (weight == 0) continue;  // a cell that is not needed may hold no data
                take(std::clamp(footprint.column - 1 + i, 0, band->GetXSize() - 1),
                     std::clamp(footprint.row - 1 + j, 0, band->GetYSize() - 1), weight);
            }
    }

    /// Elevation of a cell in metres. Throws InputError when it has none.
    [[nodiscard]] double elevation(const RasterCells::Cell& cell, const InputPlace& place,
                                   const std::string& reason) const {
        using State = RasterCells::State;
        if (cell.state == State::unreadable)
            throw InputError(place, "cannot be read from the raster" + reason,
                             "check that the file is whole (gdalinfo -checksum)");
        if (cell.state == State::no_data)
            throw InputError(place, "meets a cell without data",
                             "fill the gap, for example with gdal_fillnodata.py, or move the line");
        const double metres = to_metres * (band->GetOffset() + band->GetScale() * cell.value);
        if (!is_elevation(metres))
            throw InputError(
                place,
                fmt::format("meets a cell of {:.7g}, which is no elevation between {:g} and {:g} m",
                            cell.value, lowest_ground_m, highest_ground_m),
                fmt::format(
                    "if it stands for no data, say so with gdal_edit.py -a_nodata {:.7g} and fill the "
                    "gap or move the line; if it counts in another unit, mend the raster",
                    cell.value));
        return metres;
    }
};

ElevationRaster::ElevationRaster(const std::string& path, const RasterOptions& options) {
    const QuietGdal quiet;
    impl_ = std::make_unique<Impl>(path, options);
}

ElevationRaster::~ElevationRaster() = default;

std::vector<double> ElevationRaster::elevations(const MapLine& line) const {
    const QuietGdal quiet;
    const Transformation to_raster = impl_->from_line(line);
    const auto place = [&](std::size_t i) {
        const Vec2& at = line.points[i];
        return InputPlace{
            impl_->path, 0, "section line",
            fmt::format("({:.10g}, {:.10g}) at chainage {:.6g} m", at.x(), at.y(), line.chainage_m[i])};
    };
    RasterCells cells(*impl_->data, *impl_->band, impl_->path);
    std::vector<Footprint> footprints;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        footprints.push_back(impl_->footprint(to_raster(line.points[i]), place(i)));
        impl_->for_cells(footprints.back(), [&](int column, int row, double) { cells.ask_for(column, row); });
    }
    std::string reason;
    cells.read(reason);
    std::vector<double> elevations(line.points.size(), 0.0);
    for (std::size_t i = 0; i < elevations.size(); ++i)
        impl_->for_cells(footprints[i], [&](int column, int row, double weight) {
            elevations[i] += weight * impl_->elevation(cells.at(column, row), place(i), reason);
        });
    return elevations;
}

double ElevationRaster::cell_size_m(const MapLine& line) const {
    const QuietGdal quiet;
    const Vec2 middle = point_at(line, line.chainage_m.back() / 2);
    const Vec2 at = impl_->from_line(line)(middle);
    const MetricFrame metric(impl_->reference, at, {at});
    const Vec2 across = metric(at + Vec2(impl_->to_map[1], impl_->to_map[4])) - metric(at);
    const Vec2 down = metric(at + Vec2(impl_->to_map[2], impl_->to_map[5])) - metric(at);
    const double size = std::sqrt(std::abs(across.x() * down.y() - across.y() * down.x()));
    if (!(size > smallest_cell_m))
        impl_->refuse(fmt::format("has cells of {:g} m", size), "give a raster that is placed on a map");
    return size;
}

}  // namespace runout
