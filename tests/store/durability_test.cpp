// Writers that are killed at any moment, and disks that fill up: what was finished is there, nothing is half
// there.

#include <fcntl.h>
#include <sched.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <optional>
#include <random>

#include "store/write_ahead.h"
#include "store_fixture.h"

namespace runout {
namespace {

constexpr int kills = 100;

enum class Journal { rollback, write_ahead };

/// A run large enough that writing it takes a while, told apart by its number.
RunResult numbered_result(long number) {
    RunResult result = example_result();
    result.work.steps = number;
    result.series.resize(2000, result.series.front());
    return result;
}

/// Stores runs numbered from `first` on, opening the file for each, and says each number on `acknowledge`
/// when it is stored. Ends only by being killed.
[[noreturn]] void write_runs(const std::string& path, long first, int acknowledge, Journal journal) {
    std::optional<WriteAheadLog> log;
    if (journal == Journal::write_ahead) log.emplace(path);
    for (long number = first;; ++number) {
        Scene scene = example_scene();
        scene.material.friction_angle = 0.3 + 1e-6 * static_cast<double>(number);
        Store(path, Store::Mode::write).add(scene, numbered_result(number));
        if (write(acknowledge, &number, sizeof number) != sizeof number) _exit(3);
    }
}

/// Numbers said by a writer that was killed some time after it had said `least` of them, so that slow
/// machines get as far as fast ones.
std::vector<long> written_until_killed(const std::string& path, long first, int least, int microseconds,
                                       Journal journal) {
    int ends[2];
    EXPECT_EQ(pipe(ends), 0);
    const pid_t child = fork();
    if (child == 0) write_runs(path, first, ends[1], journal);
    close(ends[1]);
    std::vector<long> numbers;
    long number = 0;
    while (static_cast<int>(numbers.size()) < least && read(ends[0], &number, sizeof number) == sizeof number)
        numbers.push_back(number);
    usleep(static_cast<useconds_t>(microseconds));
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status)) << "the writer ended by itself";
    while (read(ends[0], &number, sizeof number) == sizeof number) numbers.push_back(number);
    close(ends[0]);
    return numbers;
}

std::vector<long> stored_numbers(const Store& store) {
    std::vector<long> numbers;
    for (const StoredRun& run : store.runs()) numbers.push_back(run.work.steps);
    return numbers;
}

class JournalTest : public StoreTest, public testing::WithParamInterface<Journal> {};
INSTANTIATE_TEST_SUITE_P(Both, JournalTest, testing::Values(Journal::rollback, Journal::write_ahead));

TEST_P(JournalTest, AWriterKilledAtAnyMomentLosesNoFinishedRunAndLeavesNoHalf) {
    std::mt19937 random(20240607);
    std::uniform_int_distribution<int> microseconds(0, 60'000);
    std::uniform_int_distribution<int> least(0, 2);
    { const Store made(path, Store::Mode::write); }
    long next = 1;
    std::size_t unsaid = 0;
    for (int k = 0; k < kills; ++k) {
        const std::size_t before = stored_numbers(Store(path, Store::Mode::read)).size();
        const std::vector<long> said =
            written_until_killed(path, next, least(random), microseconds(random), GetParam());
        const Store store(path, Store::Mode::write);  // whoever comes next, as a batch that goes on would
        const std::vector<long> stored = stored_numbers(store);
        ASSERT_EQ(raw().execAndGet("PRAGMA integrity_check").getString(), "ok");
        // One more than was said may be there: killed after its commit.
        ASSERT_GE(stored.size(), before + said.size());
        ASSERT_LE(stored.size(), before + said.size() + 1);
        for (std::size_t i = 0; i < stored.size(); ++i) ASSERT_EQ(stored[i], static_cast<long>(i) + 1);
        unsaid += stored.size() - before - said.size();
        next = static_cast<long>(stored.size()) + 1;
    }
    const long runs = next - 1;
    EXPECT_GT(runs, kills / 4) << "the writers got nowhere";
    EXPECT_EQ(count("series"), 2000 * runs);
    EXPECT_EQ(count("measure"), runs);
    EXPECT_EQ(count("invariant"), runs * static_cast<long>(example_result().invariants.size()));
    RecordProperty("runs", std::to_string(runs));
    RecordProperty("committed_but_unsaid", std::to_string(unsaid));
}

TEST_F(StoreTest, TheOneFileIsCompleteAfterAWriteAheadLog) {
    add(example_scene(), example_result());
    {
        const WriteAheadLog log(path);
        ASSERT_TRUE(log.is_on());
        Store store(path, Store::Mode::write);
        store.add(example_scene(), example_result());
        EXPECT_EQ(Store(path, Store::Mode::read).runs().size(), 2u) << "others can read meanwhile";
        EXPECT_GT(files(), 1u);
    }
    EXPECT_EQ(files(), 1u);
    EXPECT_EQ(raw().execAndGet("PRAGMA journal_mode").getString(), "delete");
    const std::string copy = path + ".copy";
    fs::copy_file(path, copy);
    EXPECT_EQ(Store(copy, Store::Mode::read).runs().size(), 2u);
}

TEST_F(StoreTest, OfTwoWriteAheadLogsTheLastToGoLeavesOneFile) {
    {
        auto first = std::make_unique<WriteAheadLog>(path), second = std::make_unique<WriteAheadLog>(path);
        EXPECT_TRUE(first->is_on() && second->is_on());
        first.reset();
        add(example_scene(), example_result());
    }
    EXPECT_EQ(files(), 1u);
    EXPECT_EQ(raw().execAndGet("PRAGMA journal_mode").getString(), "delete");
}

/// In a process of its own: a file system of 1 MiB in `directory`, that no one else sees. Exit 77: not
/// allowed.
void with_small_disk(const fs::path& directory, const std::function<bool()>& check) {
    const bool mounted = unshare(CLONE_NEWNS) == 0 &&
                         mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
                         mount("tmpfs", directory.c_str(), "tmpfs", 0, "size=1m") == 0;
    if (!mounted) _exit(77);
    _exit(check() ? 0 : 1);
}

TEST_F(StoreTest, AFullDiskIsSaidAndCostsNothingThatWasStored) {
    const auto fill_up = [this] {
        add(example_scene(), example_result());
        RunResult large = example_result();
        large.series.resize(100'000, large.series.front());
        const std::string sentence = input_error([&] { add(example_scene(), large); });
        if (!contains(sentence, path + ": does not fit on the disk; free some space")) return false;
        const bool whole = raw().execAndGet("PRAGMA integrity_check").getString() == "ok";
        const bool kept = Store(path, Store::Mode::read).runs().size() == 1;
        add(example_scene(), example_result());  // and there is room for a small one
        return whole && kept && Store(path, Store::Mode::read).runs().size() == 2;
    };
    const pid_t child = fork();
    if (child == 0) with_small_disk(directory, fill_up);
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status));
    if (WEXITSTATUS(status) == 77) GTEST_SKIP() << "mounting a file system is not allowed here";
    EXPECT_EQ(WEXITSTATUS(status), 0);
}

}  // namespace
}  // namespace runout
