#include "gis/dataset_files.h"

#include <cpl_string.h>

#include <algorithm>

#include "gis/gdal_access.h"

namespace runout {
namespace {

std::vector<std::string> files_as(const std::string& path, unsigned kind) {
    try {
        const GDALDatasetUniquePtr data = open_dataset(path, kind, "");
        const CPLStringList list(data->GetFileList());
        return {list.List(), list.List() + list.size()};
    } catch (const InputError&) {
        return {};  // whoever reads it says what is wrong with it
    }
}

}  // namespace

std::vector<std::string> dataset_files(const std::string& path) {
    const QuietGdal quiet;
    std::vector<std::string> files;
    for (const unsigned kind : {GDAL_OF_VECTOR, GDAL_OF_RASTER})
        if (files.empty()) files = files_as(path, kind);
    std::ranges::sort(files);
    files.insert(files.begin(), path);
    return files;
}

}  // namespace runout
