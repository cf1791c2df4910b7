#pragma once

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <iterator>
#include <string>

#include "example_run.h"
#include "said.h"
#include "store/store.h"
#include "temporary_folder.h"

namespace runout {

namespace fs = std::filesystem;

/// A directory of its own for every test, gone afterwards.
class StoreTest : public testing::Test {
  protected:
    long add(const Scene& scene, const RunResult& result) {
        return Store(path, Store::Mode::write).add(scene, result);
    }
    [[nodiscard]] SQLite::Database raw() const { return {path, SQLite::OPEN_READWRITE}; }
    [[nodiscard]] long count(const std::string& table) const {
        SQLite::Database database(path, SQLite::OPEN_READONLY);
        return database.execAndGet("SELECT count(*) FROM " + table).getInt64();
    }
    [[nodiscard]] std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(directory), fs::directory_iterator()));
    }

    TemporaryFolder own;
    fs::path directory = own.path();
    std::string path = own.file("results.db");
};

inline std::string refusal_to_open(const std::string& path, Store::Mode mode) {
    return input_error([&] { const Store store(path, mode); });
}

}  // namespace runout
