#pragma once

#include <chrono>
#include <string>

#include "store/store.h"

namespace runout {

/// Stores runs, and does not give one up that has ended: while another program holds the database it tries
/// again, and says so; when that lasts too long, or the database cannot be written, a database of its own is
/// made beside it, or in the folder for temporary files. `runout merge` brings that in.
class RunKeeper {
  public:
    RunKeeper(Store& store, std::string path, std::chrono::seconds patience);

    /// The id of the run in place(). Throws InputError when there is no place at all.
    long keep(const EndedRun& run);

    /// The database that took the last run.
    [[nodiscard]] const std::string& place() const { return elsewhere_.empty() ? path_ : elsewhere_; }
    [[nodiscard]] bool is_elsewhere() const { return !elsewhere_.empty(); }

  private:
    long keep_waiting(const EndedRun& run);
    long keep_elsewhere(const EndedRun& run);

    Store& store_;
    std::string path_;
    std::chrono::seconds patience_;
    std::string elsewhere_;  ///< the side database; empty: none was needed
};

}  // namespace runout
