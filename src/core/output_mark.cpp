#include "core/output_mark.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "core/sha256.h"
#include "core/version.h"

namespace runout {
namespace {

/// What stands around the hash.
struct Mark {
    const char* begin;
    const char* end;
};
constexpr Mark comment = {"<!-- Made by Runout ", " -->\n"};
constexpr Mark member = {",\n\"made_by\": \"Runout ", "\"\n}\n"};
constexpr const char* before_hash = "; sha256 of what stands before: ";

std::string mark_of(const Mark& mark, const std::string& before) {
    return fmt::format("{}{}{}{}{}", mark.begin, program_version(), before_hash, sha256_hex(before),
                       mark.end);
}

bool ends_with_mark(const std::string& text, const Mark& mark) {
    const std::size_t begin = text.rfind(mark.begin);
    if (begin == std::string::npos) return false;
    const std::size_t hash = text.find(before_hash, begin);
    if (hash == std::string::npos) return false;
    // The version between may be an older one.
    const std::string expected = sha256_hex(std::string_view(text).substr(0, begin)) + mark.end;
    return text.substr(hash + std::string_view(before_hash).size()) == expected;
}

std::string without_space_at_end(const std::string& text) {
    return text.substr(0, text.find_last_not_of(" \t\r\n") + 1);
}

}  // namespace

std::string with_output_mark(const std::string& text, const std::string& path) {
    if (text.starts_with('<') || path.ends_with(".md")) {
        const std::string before = text.ends_with('\n') ? text : text + "\n";
        return before + mark_of(comment, before);
    }
    const std::string object = without_space_at_end(text);
    if (!object.starts_with('{') || !object.ends_with('}')) return text;
    const std::string before = without_space_at_end(object.substr(0, object.size() - 1));
    return before == "{" ? text : before + mark_of(member, before);
}

bool is_unedited_output(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    return ends_with_mark(text, comment) || ends_with_mark(text, member);
}

}  // namespace runout
