#pragma once

#include <string>
#include <vector>

namespace SQLite {
class Database;
}

namespace runout {

/// What a merge did.
struct MergeCounts {
    long runs_added = 0;
    long runs_known = 0;   ///< the database had the same result of the same scenario
    long interrupted = 0;  ///< left out
    long studies = 0;
    std::vector<std::string> foreign{};  ///< "table notes": not ours, left where it is
    bool lacks_log =
        false;  ///< the file says that a -wal belongs to it, and none is there: runs may be missing
};

/// Copies into `database` what it lacks of the results database at `from`: the latest run of each scenario
/// with all that belongs to it, and the studies. Ladders of accuracy stay where they are. Call it within a
/// transaction, with `from` attached as "shard". Throws InputError naming `from`: a scenario whose result
/// differs from the one that is here, or a study that asks something else under the same name.
MergeCounts merge_attached(SQLite::Database& database, const std::string& from);

}  // namespace runout
