#pragma once

#include <ogrsf_frmts.h>

#include "gis/section_line.h"

// Shared by the files of this room only: it shows GDAL's own types.

namespace runout {

/// The layer that a query names, or the only one that holds lines. Throws InputError: no such layer, or
/// several.
OGRLayer& layer_of(GDALDataset& data, const LineQuery& query);

/// A virtual table computes its rows, from other files if it likes, and SQLite keeps no pages for it. Throws
/// InputError at `place`.
void refuse_virtual_table(GDALDataset& data, OGRLayer& layer, const InputPlace& place);

}  // namespace runout
