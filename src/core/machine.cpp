#include "core/machine.h"

#include <fmt/format.h>

#include <fstream>
#include <limits>
#include <thread>

namespace runout {
namespace {

/// "model name : ..." of Linux; empty elsewhere.
std::string processor_model() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        if (!line.starts_with("model name")) continue;
        const std::size_t start = line.find_first_not_of(" \t", line.find(':') + 1);
        return start == std::string::npos ? "" : line.substr(start);
    }
    return {};
}

}  // namespace

std::string machine_description() {
    const std::string model = processor_model();
    return fmt::format("{}, {} threads", model.empty() ? "unknown processor" : model,
                       std::thread::hardware_concurrency());
}

double available_memory_mb() {
    std::ifstream info("/proc/meminfo");
    for (std::string word; info >> word;) {
        double kibibytes = 0;
        if (word == "MemAvailable:" && info >> kibibytes) return kibibytes * 1024e-6;
        info.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    }
    return 0;
}

}  // namespace runout
