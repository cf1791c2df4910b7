#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/output_mark.h"

namespace runout {

enum class Folder { exists, may_be_made };

/// What the outputs of one call of the program must spare.
struct OutputRules {
    std::vector<std::string>
        taken{};             ///< files that this call reads, or writes by other means: never replaced
    bool overwrite = false;  ///< other files may be replaced, whatever they are

    /// Files that may be replaced without being asked to.
    std::function<bool(const std::string& path)> is_own_output = is_unedited_output;
};

/// A database and the files that SQLite keeps beside it: what an output must spare.
std::vector<std::string> database_files(const std::string& path);

/// Throws InputError, naming `option`, when write_output_file would refuse `path`: found out before the work.
/// A folder that may be made need not exist.
void check_output_place(const std::string& path, const std::string& option, Folder wanted = Folder::exists,
                        const OutputRules& rules = {});

/// The one way in which files other than databases are written. Writes `bytes` to `path` whole or not at all,
/// marked as with_output_mark does. A link is followed, and the file it names replaced. A pipe or a device is
/// written to and stays what it is. Throws InputError, naming `option`: a file that is taken, one that is
/// neither an unedited output of this program nor given up by --overwrite, one that is read-only, a folder
/// that does not exist, a disk that does not take it.
void write_output_file(const std::string& path, const std::string& option, const std::string& bytes,
                       const OutputRules& rules = {});

}  // namespace runout
