#pragma once

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "said.h"
#include "temporary_folder.h"

// The real program, as a shell sees it: exit codes, what goes to which stream, what is left on the disk.

namespace runout {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

inline std::string text_of(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

struct Outcome {
    int exit_code = -1;  ///< -1: killed by a signal
    std::string out;
    std::string err;
};

/// `runout` with its streams in files beside its working directory.
class Child {
  public:
    Child(const fs::path& folder, const Arguments& arguments) : streams_(folder / "streams") {
        fs::create_directories(streams_);
        pid_ = fork();
        if (pid_ == 0) become_runout(folder / "work", arguments);
    }

    void interrupt() const { kill(pid_, SIGINT); }
    void send(int signal) const { kill(pid_, signal); }
    void kill_at_once() const { kill(pid_, SIGKILL); }

    Outcome wait() {
        int status = 0;
        waitpid(pid_, &status, 0);
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(streams_ / "out"),
                text_of(streams_ / "err")};
    }

  private:
    [[noreturn]] void become_runout(const fs::path& work, const Arguments& arguments) const {
        const auto redirect = [](const fs::path& path, int stream) {
            dup2(open(path.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0644), stream);
        };
        redirect(streams_ / "out", STDOUT_FILENO);
        redirect(streams_ / "err", STDERR_FILENO);
        std::vector<char*> argv;
        std::string program = RUNOUT_PROGRAM;
        argv.push_back(program.data());
        Arguments copies = arguments;
        for (std::string& argument : copies) argv.push_back(argument.data());
        argv.push_back(nullptr);
        if (chdir(work.c_str()) == 0) execv(program.c_str(), argv.data());
        _exit(127);
    }

    fs::path streams_;
    pid_t pid_ = -1;
};

inline constexpr const char* slope = "chainage_m,elevation_m\n0,0.4\n0.3,0.4\n0.45,0\n2.5,0\n";

inline constexpr const char* sound_case =
    "[section]\n"                // line 1
    "file = \"section.csv\"\n"   // 2
    "[source]\n"                 // 3
    "type = \"B\"\n"             // 4
    "base_angle_deg = 35\n"      // 5
    "scarp_angle_deg = 80\n"     // 6
    "height_m = 0.15\n"          // 7
    "drop_height_m = 0.3\n"      // 8
    "[material]\n"               // 9
    "friction_angle_deg = 38\n"  // 10
    "[run]\n"                    // 11
    "resolution = 10\n";         // 12

class ProgramTest : public testing::Test {
  protected:
    ProgramTest() {
        fs::create_directories(work());
        write("section.csv", slope);
        write("case.toml", sound_case);
    }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(work(name), std::ios::binary) << text;
    }

    [[nodiscard]] fs::path work(const std::string& name = "") const { return folder_.path() / "work" / name; }

    [[nodiscard]] Outcome runout(const Arguments& arguments) const {
        return Child(folder_.path(), arguments).wait();
    }

    /// The same after what a shell does first: limits, variables of the environment, redirections at the end.
    [[nodiscard]] Outcome runout_in_shell(const std::string& before, const std::string& arguments) const {
        const fs::path streams = folder_.path() / "streams";
        fs::create_directories(streams);
        const std::string command = fmt::format(
            "cd '{}' && exec >'{}' 2>'{}'; {} exec '{}' {}", work().string(), (streams / "out").string(),
            (streams / "err").string(), before, RUNOUT_PROGRAM, arguments);
        const int status = std::system(command.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(streams / "out"),
                text_of(streams / "err")};
    }

    [[nodiscard]] std::set<std::string> files() const {
        std::set<std::string> names;
        for (const auto& entry : fs::recursive_directory_iterator(work()))
            names.insert(fs::relative(entry.path(), work()).string());
        return names;
    }

    /// A refusal: exit code 2, one sentence on standard error, nothing else, nothing written.
    void expect_refused(const Arguments& arguments, const std::vector<std::string>& parts) const {
        SCOPED_TRACE(fmt::format("runout {}", fmt::join(arguments, " ")));
        const std::set<std::string> before = files();
        const Outcome outcome = runout(arguments);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_EQ(outcome.out, "");
        EXPECT_TRUE(outcome.err.starts_with("runout: error: ")) << outcome.err;
        EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
        for (const std::string& part : parts)
            EXPECT_TRUE(contains(outcome.err, part)) << part << ": " << outcome.err;
        EXPECT_EQ(files(), before);
    }

    TemporaryFolder folder_;
};

}  // namespace runout
