#include "core/text_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <new>

#include "core/input_error.h"

namespace runout {
namespace {

class OpenFile {
  public:
    /// Without O_NONBLOCK, opening a pipe waits for somebody to write into it.
    explicit OpenFile(const std::string& path) : descriptor_(::open(path.c_str(), O_RDONLY | O_NONBLOCK)) {}
    ~OpenFile() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    [[nodiscard]] int descriptor() const { return descriptor_; }

  private:
    int descriptor_;
};

void check_regular(const OpenFile& file, const InputPlace& place, const std::string& valid) {
    if (file.descriptor() < 0 && errno == ENOENT) throw InputError(place, "does not exist", valid);
    if (file.descriptor() < 0)
        throw InputError(place, fmt::format("cannot be opened ({})", std::strerror(errno)),
                         "check that you may read it");
    struct stat status {};
    if (::fstat(file.descriptor(), &status) != 0)
        throw InputError(place, fmt::format("cannot be read ({})", std::strerror(errno)), valid);
    if (S_ISDIR(status.st_mode)) throw InputError(place, "is a directory", valid);
    if (!S_ISREG(status.st_mode))
        throw InputError(place, "is a pipe or a device, which may never end",
                         "write what it gives into a file, and give that");
}

std::string all_bytes(const OpenFile& file, const InputPlace& place) {
    std::string text;
    std::array<char, 1U << 16U> block{};
    while (true) {
        const ssize_t count = ::read(file.descriptor(), block.data(), block.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0)
            throw InputError(place, fmt::format("cannot be read to its end ({})", std::strerror(errno)),
                             "check the disk that it is on");
        if (count == 0) return text;
        text.append(block.data(), static_cast<std::size_t>(count));
        if (text.size() > longest_text_bytes)
            throw InputError(place, fmt::format("is longer than {} MiB", longest_text_bytes >> 20U),
                             "give the points of one section only");
    }
}

}  // namespace

std::string read_text_file(const std::string& path, const std::string& valid) {
    const InputPlace place{path, 0, "", ""};
    if (path.find('\0') != std::string::npos) throw InputError(place, "has a zero byte in its name", valid);
    const OpenFile file(path);
    check_regular(file, place, valid);
    try {
        return all_bytes(file, place);
    } catch (const std::bad_alloc&) {
        throw InputError(place, "needs more memory than there is", "give a shorter file");
    }
}

}  // namespace runout
