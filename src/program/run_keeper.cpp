#include "program/run_keeper.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <filesystem>

#include "core/input_error.h"
#include "program/log.h"
#include "store/database_in_use.h"

namespace runout {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds one_try{1};
constexpr std::chrono::seconds between_messages{10};

/// "study-side-20240531T093000Z-4711.db": no other program makes the same.
std::string side_name(const std::string& path) {
    return fmt::format("{}-side-{:%Y%m%dT%H%M%SZ}-{}.db", fs::path(path).stem().string(),
                       fmt::gmtime(std::chrono::system_clock::now()), getpid());
}

/// Where a side database may lie, the best first.
std::vector<std::string> side_places(const std::string& path) {
    std::error_code failure;
    const fs::path temporary = fs::temp_directory_path(failure);
    std::vector<std::string> places = {(fs::path(path).parent_path() / side_name(path)).string()};
    if (!failure) places.push_back((temporary / side_name(path)).string());
    return places;
}

}  // namespace

RunKeeper::RunKeeper(Store& store, std::string path, std::chrono::seconds patience)
    : store_(store), path_(std::move(path)), patience_(patience) {}

long RunKeeper::keep(const EndedRun& run) {
    if (is_elsewhere()) return keep_elsewhere(run);
    try {
        return keep_waiting(run);
    } catch (const std::exception& error) {  // whatever is wrong with that file, the run is not
        log_warning("{}: {}", path_, error.what());
        return keep_elsewhere(run);
    }
}

long RunKeeper::keep_waiting(const EndedRun& run) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + patience_;
    auto next_message = Clock::now();
    store_.set_patience(one_try);
    while (true) {
        try {
            return store_.add(run);
        } catch (const DatabaseInUse&) {
            const auto now = Clock::now();
            if (now >= end) throw;
            if (now < next_message) continue;
            next_message = now + between_messages;
            log_warning("{} is in use by another program; trying for {} s more", path_,
                        std::chrono::ceil<std::chrono::seconds>(end - now).count());
        }
    }
}

long RunKeeper::keep_elsewhere(const EndedRun& run) {
    std::string last_problem;
    for (const std::string& place : is_elsewhere() ? std::vector{elsewhere_} : side_places(path_)) {
        try {
            Store side(place, Store::Mode::write);
            const long run_id = side.add(run);
            elsewhere_ = place;
            return run_id;
        } catch (const InputError& error) {
            last_problem = error.what();
        }
    }
    throw InputError({.file = path_, .line = 0, .key = {}, .value = {}},
                     "cannot take the run, nor can a database beside it (" + last_problem + ")",
                     "free some space and run it again");
}

}  // namespace runout
