#include "fuzz/bytes.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace runout::fuzz {

void require(bool holds, const char* promise) {
    if (holds) return;
    fmt::print(stderr, "broken promise: {}\n", promise);
    std::abort();
}

std::string written(std::span<const std::uint8_t> bytes, const char* extension) {
    static const std::string stem =
        (std::filesystem::temp_directory_path() / fmt::format("runout-fuzz-{}", getpid())).string();
    std::ofstream file(stem + extension, std::ios::binary | std::ios::trunc);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return stem + extension;
}

double Numbers::number() {
    const std::uint8_t kind = byte();
    if (kind > 250) {
        double any = 0;
        for (std::size_t k = 0; k < sizeof any; ++k) reinterpret_cast<std::uint8_t*>(&any)[k] = byte();
        return any;
    }
    const int whole = byte() * 256 + byte() - 32768;
    return whole * std::pow(10.0, -static_cast<double>(kind % 5));
}

double Numbers::size() {
    return std::abs(number());
}

std::string Numbers::text() {
    std::string text;
    for (int left = byte(); left > 0 && !empty(); --left) text += static_cast<char>(byte());
    return text;
}

}  // namespace runout::fuzz
