#pragma once

#include <chrono>
#include <memory>
#include <string>

namespace SQLite {
class Database;
}

namespace runout {

/// While it lives, what is stored in the database goes through SQLite's write-ahead log: a commit then is one
/// write that the disk has to confirm, in place of four with a rollback journal, and as safe against a kill
/// and a power cut. For programs that store many short runs. Meanwhile two more files lie beside the database
/// (-wal, -shm); a program that is killed leaves them, and the next one that opens the database takes in what
/// they hold. Afterwards the one file is complete again, unless another program still writes.
class WriteAheadLog {
  public:
    /// `path` is an existing results database. Where the log cannot be had, as when another program is
    /// writing or the disk is a network's that has no shared memory, the journal stays as it is.
    explicit WriteAheadLog(const std::string& path);
    ~WriteAheadLog();
    WriteAheadLog(const WriteAheadLog&) = delete;
    WriteAheadLog& operator=(const WriteAheadLog&) = delete;

    /// Brings what is in the log into the one file, now and then: the first time, and when some seconds have
    /// passed since. What is copied without its log then lacks no more than that.
    void checkpoint_now_and_then();

    /// Whether the log is in use.
    [[nodiscard]] bool is_on() const { return on_; }

  private:
    std::unique_ptr<SQLite::Database> database_;
    std::chrono::steady_clock::time_point next_checkpoint_{};
    bool on_ = false;
};

}  // namespace runout
