#pragma once

#include <memory>
#include <string>
#include <vector>

namespace SQLite {
class Database;
class Exception;
}  // namespace SQLite

namespace runout {

/// Opens an existing results database; nothing can be changed through the connection.
/// Throws InputError: no such file, not a Runout database, another version.
std::unique_ptr<SQLite::Database> open_for_reading(const std::string& path);

/// Opens a results database that can be written now, creating or migrating it first if need be.
/// Throws InputError and leaves the disk as it was: not a Runout database, a newer version, an unwritable
/// place.
std::unique_ptr<SQLite::Database> open_for_writing(const std::string& path);

/// Reads the whole of a results database, so that damage is said before any of it is used, and returns what
/// it holds beside the format. Throws InputError.
std::vector<std::string> check_whole(const std::string& path);

/// Throws the InputError that says what the file or the disk does not allow. An error that is nobody's input,
/// such as a violated constraint, is thrown on as it is.
[[noreturn]] void throw_storage_error(const std::string& path, const SQLite::Exception& error);

}  // namespace runout
