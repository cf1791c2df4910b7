#pragma once

#include <string>

namespace runout {

// What a database file and those beside it say without SQLite, which would act on them.

/// Whether the file says that it is written through a write-ahead log.
bool says_write_ahead(const std::string& path);

/// Whether the file says so and no log lies beside it: it was copied without one from a program that was
/// killed, or another program closed it last. In the first case runs may be missing.
bool lacks_its_log(const std::string& path);

/// Whether it is the file that standard output or standard error goes to, such as /dev/stdout.
bool is_output_stream(const std::string& path);

/// Throws InputError when a file beside the database is none that SQLite leaves after a write of ours: a
/// journal that names a further file, which SQLite would delete; a journal or a log that is no ordinary file.
void check_journals(const std::string& path);

/// A name by which SQLite opens the database and cannot change it: as "file:///a/b.db?mode=ro".
std::string read_only_uri(const std::string& path);

}  // namespace runout
