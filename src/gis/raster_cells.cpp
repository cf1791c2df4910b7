#include "gis/raster_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "gis/drivers.h"
#include "gis/gdal_access.h"

namespace runout {
namespace {

constexpr double megabyte = 1024.0 * 1024.0;
constexpr double largest_block_bytes = 256 * megabyte;
constexpr int deepest_nesting = 8;
/// Cells of one row that are further apart than this are read apart.
constexpr int widest_gap = 64;

/// What unpacking one block of a data set takes; pixels of all bands come together where they are
/// interleaved.
double block_bytes(GDALDataset& data) {
    int columns = 0;
    int rows = 0;
    GDALRasterBand& band = *data.GetRasterBand(1);
    band.GetBlockSize(&columns, &rows);
    const char* interleave = data.GetMetadataItem("INTERLEAVE", "IMAGE_STRUCTURE");
    const bool together = interleave != nullptr && EQUAL(interleave, "PIXEL");
    return 1.0 * columns * rows * GDALGetDataTypeSizeBytes(band.GetRasterDataType()) *
           (together ? data.GetRasterCount() : 1);
}

/// A grid of text whose head asks for more cells than its bytes can hold, each a digit and what parts it from
/// the next: GDAL would look for every row of it.
void check_holds_its_cells(GDALDataset& data, const std::string& path) {
    const std::string driver = data.GetDriver() != nullptr ? data.GetDriver()->GetDescription() : "";
    VSIStatBufL file{};
    if ((driver != "AAIGrid" && driver != "GRASSASCIIGrid") || VSIStatL(path.c_str(), &file) != 0) return;
    const double cells = 1.0 * data.GetRasterXSize() * data.GetRasterYSize();
    const auto bytes = static_cast<double>(file.st_size);
    if (2 * cells - 1 > bytes)
        throw InputError({path, 0, "", ""},
                         fmt::format("is cut off: {:.0f} bytes are too few for {} x {} cells", bytes,
                                     data.GetRasterXSize(), data.GetRasterYSize()),
                         "take a copy that is whole");
}

bool is_virtual(GDALDataset& data) {
    return data.GetDriver() != nullptr && EQUAL(data.GetDriver()->GetDescription(), "VRT");
}

/// The largest block of a data set and of what it is put together from, in bytes, and the file that has it.
std::pair<double, std::string> largest_block(GDALDataset& data, const std::string& path, int depth) {
    check_holds_its_cells(data, path);
    std::pair<double, std::string> largest{block_bytes(data), path};
    if (!is_virtual(data) || depth >= deepest_nesting) return largest;
    const CPLStringList files(data.GetFileList());
    for (int i = 0; i < files.size(); ++i) {
        const char* const file = files[i];
        if (EQUAL(file, data.GetDescription())) continue;
        const GDALDatasetUniquePtr source(
            GDALDataset::Open(file, GDAL_OF_RASTER | GDAL_OF_READONLY, raster_drivers()));
        if (source && source->GetRasterCount() > 0)
            largest = std::max(largest, largest_block(*source, file, depth + 1));
    }
    return largest;
}

/// Refuses what would be unpacked for minutes, and lets the cache hold two of the blocks that are left.
void make_room_for_blocks(GDALDataset& data, const std::string& path) {
    const auto [bytes, file] = largest_block(data, path, 0);
    if (bytes > largest_block_bytes)
        throw InputError(
            {file, 0, "", ""},
            fmt::format("is stored in pieces of {:.0f} MB, of which each is read whole for one cell",
                        bytes / megabyte),
            fmt::format("the limit is {:.0f} MB: gdal_translate -co TILED=YES -co COMPRESS=DEFLATE "
                        "makes a raster of small pieces",
                        largest_block_bytes / megabyte));
    GDALSetCacheMax64(std::max(GDALGetCacheMax64(), static_cast<GIntBig>(2 * bytes + megabyte)));
}

}  // namespace

RasterCells::RasterCells(GDALDataset& data, GDALRasterBand& band, const std::string& path)
    : band_(band), mask_((band.GetMaskFlags() & GMF_ALL_VALID) != 0 ? nullptr : band.GetMaskBand()) {
    make_room_for_blocks(data, path);
    band.GetBlockSize(&block_columns_, &block_rows_);
}

bool RasterCells::is_before(const Cell& a, const Cell& b) const {
    const auto place = [this](const Cell& cell) {
        return std::tuple(cell.row / block_rows_, cell.column / block_columns_, cell.row, cell.column);
    };
    return place(a) < place(b);
}

bool RasterCells::goes_on(const Cell& before, const Cell& cell) const {
    return cell.row == before.row && cell.column - before.column <= widest_gap &&
           cell.column / block_columns_ == before.column / block_columns_;
}

void RasterCells::read(std::string& reason) {
    std::ranges::sort(cells_, [this](const Cell& a, const Cell& b) { return is_before(a, b); });
    const auto same = [](const Cell& a, const Cell& b) { return a.row == b.row && a.column == b.column; };
    cells_.erase(std::unique(cells_.begin(), cells_.end(), same), cells_.end());
    for (auto first = cells_.begin(); first != cells_.end();) {
        auto end = first + 1;
        while (end != cells_.end() && goes_on(*(end - 1), *end)) ++end;
        read_run(first, end, reason);
        first = end;
    }
}

/// Cells of one row and one block.
void RasterCells::read_run(Iterator first, Iterator end, std::string& reason) {
    const int left = first->column;
    const int width = (end - 1)->column - left + 1;
    std::vector<double> values(static_cast<std::size_t>(width));
    std::vector<unsigned char> valid(values.size(), 255);
    CPLErrorReset();
    const bool good = band_.RasterIO(GF_Read, left, first->row, width, 1, values.data(), width, 1,
                                     GDT_Float64, 0, 0, nullptr) == CE_None &&
                      (mask_ == nullptr || mask_->RasterIO(GF_Read, left, first->row, width, 1, valid.data(),
                                                           width, 1, GDT_Byte, 0, 0, nullptr) == CE_None);
    if (!good) {
        if (reason.empty()) reason = gdal_reason();
        return;
    }
    for (auto cell = first; cell != end; ++cell) {
        const auto i = static_cast<std::size_t>(cell->column - left);
        cell->value = values[i];
        cell->state = valid[i] != 0 && !std::isnan(values[i]) ? State::value : State::no_data;
    }
}

const RasterCells::Cell& RasterCells::at(int column, int row) const {
    const Cell wanted{column, row};
    return *std::ranges::lower_bound(cells_, wanted,
                                     [this](const Cell& a, const Cell& b) { return is_before(a, b); });
}

}  // namespace runout
