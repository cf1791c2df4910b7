#include "store/database_file.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "core/input_error.h"

namespace runout {
namespace {

namespace fs = std::filesystem;

/// Where SQLite looks for the files beside it: at the end of all links.
fs::path place_of(const std::string& path) {
    std::error_code failure;
    const fs::path place = fs::canonical(path, failure);
    return failure ? fs::absolute(path) : place;
}

std::string beside(const std::string& path, const char* ending) {
    return place_of(path).string() + ending;
}

/// The end of a journal that names a super-journal
/// (https://www.sqlite.org/fileformat.html#the_rollback_journal and readSuperJournal() of SQLite). Runout
/// writes no transaction over several files, so that it leaves none.
bool names_further_file(const std::string& journal) {
    constexpr std::array<unsigned char, 8> magic = {0xd9, 0xd5, 0x05, 0xf9, 0x20, 0xa1, 0x63, 0xd7};
    std::ifstream stream(journal, std::ios::binary);
    std::array<char, 8> last{};
    stream.seekg(-static_cast<std::streamoff>(last.size()), std::ios::end);
    if (!stream.read(last.data(), last.size())) return false;
    for (std::size_t i = 0; i < magic.size(); ++i)
        if (static_cast<unsigned char>(last[i]) != magic[i]) return false;
    return true;
}

std::string percent_encoded(const std::string& text) {
    std::string result;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        const bool plain =
            std::isalnum(byte) != 0 || std::string_view("/-_.~").find(c) != std::string_view::npos;
        result += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
    }
    return result;
}

}  // namespace

bool says_write_ahead(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    std::array<char, 20> header{};
    if (!stream.read(header.data(), header.size())) return false;
    return header[18] == 2 && header[19] == 2;  // versions of the format that writing and reading it ask for
}

bool lacks_its_log(const std::string& path) {
    std::error_code ignored;
    return says_write_ahead(path) && !fs::exists(beside(path, "-wal"), ignored);
}

bool is_output_stream(const std::string& path) {
    struct stat file {
    }, stream{};
    if (stat(path.c_str(), &file) != 0) return false;
    for (const int number : {STDOUT_FILENO, STDERR_FILENO})
        if (fstat(number, &stream) == 0 && stream.st_dev == file.st_dev && stream.st_ino == file.st_ino)
            return true;
    return false;
}

void check_journals(const std::string& path) {
    std::error_code ignored;
    for (const char* ending : {"-journal", "-wal", "-shm"}) {
        const std::string file = beside(path, ending);
        const fs::file_status status = fs::symlink_status(file, ignored);
        if (fs::exists(status) && !fs::is_regular_file(status))
            throw InputError({.file = file, .line = 0, .key = {}, .value = {}},
                             "lies beside a database and is no ordinary file", "remove it");
    }
    const std::string journal = beside(path, "-journal");
    if (fs::exists(journal, ignored) && names_further_file(journal))
        throw InputError({.file = journal, .line = 0, .key = {}, .value = {}},
                         "names a further file, which no journal of Runout does",
                         "take the database from a source that you trust, without this file");
}

std::string read_only_uri(const std::string& path) {
    // Without a log nobody has it open; SQLite would make one, and could not remove it again.
    const char* const options = lacks_its_log(path) ? "?mode=ro&immutable=1" : "?mode=ro";
    return "file://" + percent_encoded(fs::absolute(path).string()) + options;
}

}  // namespace runout
