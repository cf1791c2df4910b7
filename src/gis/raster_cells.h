#pragma once

#include <gdal_priv.h>

#include <string>
#include <vector>

// Shared by the files of this room only: it shows GDAL's own types.

namespace runout {

/// Values of single cells of a band. A band is stored in blocks, and a compressed block has to be unpacked
/// whole for one cell: cells are asked for first and then read block by block, each block once.
class RasterCells {
  public:
    enum class State { value, no_data, unreadable };
    struct Cell {
        int column = 0;
        int row = 0;
        double value = 0;  ///< as stored, without offset and scale
        State state = State::unreadable;
    };

    /// Throws InputError that names `path` when a block of the band, or of a source of a virtual raster, is
    /// too large to be unpacked at a time.
    RasterCells(GDALDataset& data, GDALRasterBand& band, const std::string& path);

    void ask_for(int column, int row) { cells_.push_back({column, row, 0, State::unreadable}); }
    /// Reads all cells that were asked for; `reason` says why some could not be.
    void read(std::string& reason);
    /// A cell that was asked for and read.
    [[nodiscard]] const Cell& at(int column, int row) const;

  private:
    using Iterator = std::vector<Cell>::iterator;

    [[nodiscard]] bool is_before(const Cell& a, const Cell& b) const;
    [[nodiscard]] bool goes_on(const Cell& before, const Cell& cell) const;
    void read_run(Iterator first, Iterator end, std::string& reason);

    GDALRasterBand& band_;
    GDALRasterBand* mask_;  ///< none where every cell is valid
    int block_columns_ = 1;
    int block_rows_ = 1;
    std::vector<Cell> cells_;
};

}  // namespace runout
