#pragma once

#include <optional>
#include <string>
#include <vector>

namespace runout {

/// Which runs are to go; one of the three.
struct RunSelection {
    std::vector<long> run_ids{};
    std::optional<long> study_id{};  ///< its runs but those that another study shares, and the study itself
    std::string ended_before_utc{};  ///< ISO 8601
};

struct DoomedRun {
    long run_id = 0;
    std::string name;
    std::string status;
    std::string ended_utc;
};

/// What a removal takes away: whole runs, and what rests on them.
struct Removal {
    std::vector<DoomedRun> runs;
    std::vector<std::string> ladders;  ///< names of the studies of accuracy that lose a run, and go whole
    std::optional<long> study_id;
    std::string study;     ///< name of the study that goes; empty: none
    long shared_runs = 0;  ///< of the study, kept because another study has them too
};

/// Looks and changes nothing. Throws InputError: no such run, or whatever opening a database for reading
/// refuses.
Removal plan_removal(const std::string& path, const RunSelection& selection);

/// What came of a removal.
struct Removed {
    long bytes_given_back = 0;
    bool space_given_back = true;  ///< false: the disk has no room for the copy that this needs
};

/// Removes exactly what was planned, with scenarios, sources, sections and map lines that nothing else uses,
/// in one transaction, and makes the file as small as it then can be. Throws InputError and changes nothing
/// when another program has the database open.
Removed remove_runs(const std::string& path, const Removal& removal);

}  // namespace runout
