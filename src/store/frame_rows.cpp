#include "store/frame_rows.h"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>

#include "store/columns.h"
#include "store/known_tables.h"
#include "store/real_value.h"

namespace runout {
namespace {

// The codes are little-endian, and so is every machine that this is built for.
static_assert(std::endian::native == std::endian::little);

constexpr const char* blobs = "x, y, speed, pressure";

std::string scale_names() {
    std::vector<std::string> names;
    for (const auto& column : frame_scale_columns()) names.emplace_back(column.name);
    return fmt::format("{}", fmt::join(names, ", "));
}

/// SQLite takes a null pointer for NULL, and an empty vector may have one.
template <class Code>
void bind_codes(SQLite::Statement& statement, int place, const std::vector<Code>& codes) {
    const void* bytes = codes.empty() ? static_cast<const void*>("") : codes.data();
    statement.bind(place, bytes, static_cast<int>(codes.size() * sizeof(Code)));
}

template <class Code>
std::vector<Code> codes_of(const SQLite::Column& column) {
    std::vector<Code> codes(static_cast<std::size_t>(column.getBytes()) / sizeof(Code));
    if (!codes.empty()) std::memcpy(codes.data(), column.getBlob(), codes.size() * sizeof(Code));
    return codes;
}

/// A particle has one place in each array of a picture, and stays in those that follow; more may come.
void check_frames(const std::vector<Frame>& frames, long run_id) {
    std::size_t least = 0;
    for (const Frame& frame : frames) {
        const std::size_t count = frame.x.size();
        const bool whole =
            frame.y.size() == count && frame.speed.size() == count && frame.pressure.size() == count;
        if (!whole || (count > 0 && count < least))
            throw DamagedData(fmt::format("has pictures of run {} with parts missing", run_id));
        least = std::max(least, count);
    }
}

}  // namespace

void insert_frames(SQLite::Database& database, long run_id, const std::vector<Frame>& frames) {
    std::string places = "?, ?";
    for (std::size_t i = 0; i < frame_scale_columns().size() + 4; ++i) places += ", ?";
    SQLite::Statement statement(
        database, fmt::format("INSERT INTO frame (run_id, row_index, {}, {}) VALUES ({})", scale_names(),
                              blobs, places));
    for (std::size_t i = 0; i < frames.size(); ++i) {
        int place = 0;
        statement.bind(++place, run_id);
        statement.bind(++place, static_cast<long>(i));
        for (const auto& column : frame_scale_columns())
            statement.bind(++place, frames[i].scale.*column.value);
        bind_codes(statement, ++place, frames[i].x);
        bind_codes(statement, ++place, frames[i].y);
        bind_codes(statement, ++place, frames[i].speed);
        bind_codes(statement, ++place, frames[i].pressure);
        statement.exec();
        statement.reset();
    }
}

std::vector<Frame> select_frames(SQLite::Database& database, long run_id) {
    SQLite::Statement statement(
        database,
        fmt::format("SELECT {}, {} FROM frame WHERE run_id = ? ORDER BY row_index", scale_names(), blobs));
    statement.bind(1, run_id);
    std::vector<Frame> frames;
    while (statement.executeStep()) {
        Frame& frame = frames.emplace_back();
        int place = 0;
        for (const auto& column : frame_scale_columns())
            frame.scale.*column.value = coordinate(statement.getColumn(place++));
        frame.x = codes_of<std::uint16_t>(statement.getColumn(place++));
        frame.y = codes_of<std::uint16_t>(statement.getColumn(place++));
        frame.speed = codes_of<std::uint8_t>(statement.getColumn(place++));
        frame.pressure = codes_of<std::uint8_t>(statement.getColumn(place++));
    }
    check_frames(frames, run_id);
    return frames;
}

}  // namespace runout
