#pragma once

#include <string>

namespace runout {

/// A file in GDAL's memory, gone with this object. For this room only.
class MemoryFile {
  public:
    /// Not there yet; `ending` as ".gpkg".
    explicit MemoryFile(const std::string& ending);
    MemoryFile(const std::string& ending, const std::string& bytes);
    ~MemoryFile();
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    [[nodiscard]] const std::string& path() const { return path_; }
    [[nodiscard]] std::string bytes() const;

  private:
    std::string path_;
};

}  // namespace runout
