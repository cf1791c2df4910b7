#include "gis/memory_file.h"

#include <cpl_vsi.h>
#include <fmt/format.h>

#include <stdexcept>

namespace runout {

MemoryFile::MemoryFile(const std::string& ending)
    : path_(fmt::format("/vsimem/runout-{}{}", static_cast<const void*>(this), ending)) {}

MemoryFile::MemoryFile(const std::string& ending, const std::string& bytes) : MemoryFile(ending) {
    VSILFILE* const file = VSIFOpenL(path_.c_str(), "wb");
    if (file == nullptr) throw std::runtime_error("GDAL has no memory for a file");
    const std::size_t written = VSIFWriteL(bytes.data(), 1, bytes.size(), file);
    if (VSIFCloseL(file) != 0 || written != bytes.size())
        throw std::runtime_error("GDAL has no memory for a file");
}

MemoryFile::~MemoryFile() {
    VSIUnlink(path_.c_str());
}

std::string MemoryFile::bytes() const {
    vsi_l_offset size = 0;
    const GByte* const data = VSIGetMemFileBuffer(path_.c_str(), &size, FALSE);
    return data == nullptr ? "" : std::string(reinterpret_cast<const char*>(data), size);
}

}  // namespace runout
