#include "core/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <random>

#include "core/input_error.h"
#include "core/output_folder.h"

namespace runout {
namespace {

namespace fs = std::filesystem;

InputError refusal(const std::string& path, const std::string& option, const std::string& problem,
                   const std::string& valid) {
    return InputError({.file = option, .line = 0, .key = {}, .value = path}, problem, valid);
}

bool is_same(const struct stat& one, const struct stat& other) {
    return one.st_dev == other.st_dev && one.st_ino == other.st_ino;
}

/// The same file, by whatever name or link; of files that do not exist, the same place.
bool is_same_file(const std::string& one, const std::string& other) {
    struct stat a {
    }, b{};
    const bool has_one = stat(one.c_str(), &a) == 0, has_other = stat(other.c_str(), &b) == 0;
    if (has_one && has_other) return is_same(a, b);
    if (has_one != has_other) return false;
    std::error_code failure;
    const fs::path place = fs::weakly_canonical(fs::absolute(one), failure);
    return !failure && place == fs::weakly_canonical(fs::absolute(other), failure) && !failure;
}

/// Where bytes go that are written in place: to an open stream, or to a pipe or a device by its name.
bool is_standard_stream(const struct stat& target, int stream) {
    struct stat open_file {};
    return fstat(stream, &open_file) == 0 && is_same(target, open_file);
}

bool is_written_in_place(const std::string& path) {
    struct stat target {};
    if (stat(path.c_str(), &target) != 0) return false;
    return S_ISFIFO(target.st_mode) || S_ISCHR(target.st_mode) || is_standard_stream(target, STDOUT_FILENO) ||
           is_standard_stream(target, STDERR_FILENO);
}

bool write_all(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

[[noreturn]] void fail(const std::string& path, const std::string& option) {
    throw refusal(path, option, fmt::format("cannot be written ({})", std::strerror(errno)),
                  "check permissions and free space");
}

void write_in_place(const std::string& path, const std::string& option, const std::string& bytes) {
    struct stat target {};
    if (stat(path.c_str(), &target) != 0) fail(path, option);
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
        if (!is_standard_stream(target, stream)) continue;
        std::fflush(nullptr);  // what was printed before comes first
        if (!write_all(stream, bytes)) fail(path, option);
        return;
    }
    const int file = open(path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
    if (file < 0) fail(path, option);
    const bool written = write_all(file, bytes);
    const int reason = errno;
    close(file);
    errno = reason;
    if (!written) fail(path, option);
}

/// A file beside `target` that no one else has made, and that is gone again unless it takes the target's
/// place.
class UnfinishedFile {
  public:
    explicit UnfinishedFile(const fs::path& target) : target_(target) {
        std::random_device random;
        for (int tries = 0; tries < 16 && file_ < 0; ++tries) {
            name_ = (target.parent_path() / fmt::format(".runout-{:08x}{:08x}.part", random(), random()))
                        .string();
            file_ = open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
            if (file_ < 0 && errno != EEXIST) break;
        }
    }
    UnfinishedFile(const UnfinishedFile&) = delete;
    UnfinishedFile& operator=(const UnfinishedFile&) = delete;
    ~UnfinishedFile() {
        const int reason = errno;
        if (file_ >= 0) close(file_);
        if (file_ >= 0 && !done_) unlink(name_.c_str());
        errno = reason;
    }

    /// False, with errno, when the disk does not take it. A target that did not exist before must not exist
    /// now.
    bool write(const std::string& bytes, bool existed) {
        struct stat before {};
        if (file_ < 0) return false;
        if (existed && stat(target_.c_str(), &before) == 0 && fchmod(file_, before.st_mode & 0777U) != 0)
            return false;
        if (!write_all(file_, bytes) || fsync(file_) != 0) return false;
        done_ = take_place(existed);
        return done_;
    }

  private:
    [[nodiscard]] bool take_place(bool existed) const {
        if (existed) return rename(name_.c_str(), target_.c_str()) == 0;
        if (renameat2(AT_FDCWD, name_.c_str(), AT_FDCWD, target_.c_str(), RENAME_NOREPLACE) == 0) return true;
        const bool unknown_here = errno == EINVAL || errno == ENOSYS;
        return unknown_here && rename(name_.c_str(), target_.c_str()) == 0;
    }

    fs::path target_;
    std::string name_;
    int file_ = -1;
    bool done_ = false;
};

void check_existing(const std::string& path, const std::string& option, const OutputRules& rules) {
    if (is_written_in_place(path)) return;
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored))
        throw refusal(path, option, "is no ordinary file", "give the name of a file");
    constexpr auto writable = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
    if ((fs::status(path, ignored).permissions() & writable) == fs::perms::none)
        throw refusal(path, option, "is read-only", "give another name, or make it writable");
    if (!rules.overwrite && !rules.is_own_output(path))
        throw refusal(path, option, "exists, and is not known as an unedited output of this program",
                      "give another name, or --overwrite");
}

/// The file that a chain of links ends at; the links stay.
fs::path end_of_links(const std::string& path) {
    std::error_code ignored;
    return fs::is_symlink(path, ignored) ? fs::canonical(path) : fs::absolute(path);
}

}  // namespace

std::vector<std::string> database_files(const std::string& path) {
    return {path, path + "-journal", path + "-wal", path + "-shm"};
}

void check_output_place(const std::string& path, const std::string& option, Folder wanted,
                        const OutputRules& rules) {
    std::error_code ignored;
    if (path.empty()) throw refusal(path, option, "is empty", "give the name of a file");
    if (path.find('\0') != std::string::npos)
        throw refusal(path, option, "holds a zero byte", "give the name of a file");
    if (fs::is_directory(path, ignored))
        throw refusal(path, option, "is a directory", "give the name of a file");
    if (std::ranges::any_of(rules.taken, [&](const auto& file) { return is_same_file(path, file); }))
        throw refusal(path, option, "is a file that this command reads or writes itself",
                      "give another name");
    fs::path folder = fs::absolute(path).parent_path();
    while (wanted == Folder::may_be_made && !fs::exists(folder, ignored)) folder = folder.parent_path();
    if (!fs::is_directory(folder, ignored))
        throw refusal(path, option, "lies in a folder that does not exist", "make " + folder.string());
    if (fs::exists(path, ignored)) return check_existing(path, option, rules);
    if (fs::is_symlink(path, ignored))
        throw refusal(path, option, "is a link to a file that does not exist", "give the name of a file");
}

void make_output_folder(const std::string& path, const std::string& option) {
    std::error_code failure;
    fs::create_directories(path, failure);
    if (failure || !fs::is_directory(path, failure))
        throw refusal(path, option, "cannot be made a folder", "give a folder that you may write");
}

void write_output_file(const std::string& path, const std::string& option, const std::string& bytes,
                       const OutputRules& rules) {
    check_output_place(path, option, Folder::exists, rules);
    if (is_written_in_place(path)) return write_in_place(path, option, bytes);
    const fs::path target = end_of_links(path);
    UnfinishedFile unfinished(target);
    std::error_code ignored;
    if (!unfinished.write(with_output_mark(bytes, path), fs::exists(target, ignored))) fail(path, option);
}

}  // namespace runout
