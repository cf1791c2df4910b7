#include "store/write_ahead.h"

#include <SQLiteCpp/Database.h>

#include "store/database.h"

namespace runout {
namespace {

constexpr std::chrono::seconds between_checkpoints{3};

/// Whether the journal of the file is of this kind now.
bool set_journal(SQLite::Database& database, const std::string& kind) {
    try {
        return database.execAndGet("PRAGMA journal_mode = " + kind).getString() == kind;
    } catch (const SQLite::Exception&) {
        return false;  // in use by another program
    }
}

}  // namespace

WriteAheadLog::WriteAheadLog(const std::string& path) : database_(open_for_writing(path)) {
    // Nothing here is worth waiting for: with the other kind of journal all is right too.
    database_->exec("PRAGMA busy_timeout = 0");
    on_ = set_journal(*database_, "wal");
}

void WriteAheadLog::checkpoint_now_and_then() {
    const auto now = std::chrono::steady_clock::now();
    if (!on_ || now < next_checkpoint_) return;
    next_checkpoint_ = now + between_checkpoints;
    try {
        database_->exec("PRAGMA wal_checkpoint(PASSIVE)");
    } catch (const SQLite::Exception&) {
        // Another program reads or writes what would be moved; the log keeps it.
    }
}

WriteAheadLog::~WriteAheadLog() {
    set_journal(*database_, "delete");
}

}  // namespace runout
