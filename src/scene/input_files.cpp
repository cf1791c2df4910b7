#include "scene/input_files.h"

#include "gis/dataset_files.h"

namespace runout {

std::vector<std::string> input_files(const CaseSpec& spec) {
    const MapSection& map = spec.section.map;
    std::vector<std::string> files;
    for (const std::string& file : {spec.file, spec.section.file, spec.shaking_record})
        if (!file.empty()) files.push_back(file);
    for (const std::string& set : {map.raster, map.line.file, spec.map_places.file})
        if (!set.empty())
            for (const std::string& file : dataset_files(set)) files.push_back(file);
    return files;
}

}  // namespace runout
