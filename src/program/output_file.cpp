#include "program/output_file.h"

#include <filesystem>
#include <fstream>

#include "core/input_error.h"

namespace runout {
namespace {

namespace fs = std::filesystem;

InputError refusal(const std::string& path, const std::string& option, const std::string& problem,
                   const std::string& valid) {
    return InputError({.file = option, .line = 0, .key = {}, .value = path}, problem, valid);
}

}  // namespace

void check_output_place(const std::string& path, const std::string& option, Folder wanted) {
    std::error_code ignored;
    if (path.empty()) throw refusal(path, option, "is empty", "give the name of a file");
    if (fs::is_directory(path, ignored))
        throw refusal(path, option, "is a directory", "give the name of a file");
    fs::path folder = fs::absolute(path).parent_path();
    while (wanted == Folder::may_be_made && !fs::exists(folder, ignored)) folder = folder.parent_path();
    if (!fs::is_directory(folder, ignored))
        throw refusal(path, option, "lies in a folder that does not exist", "make " + folder.string());
}

void write_output_file(const std::string& path, const std::string& option, const std::string& text) {
    check_output_place(path, option);
    const fs::path unfinished = path + ".part";
    std::ofstream file(unfinished, std::ios::binary);
    file << text;
    file.close();
    std::error_code failure;
    if (file) fs::rename(unfinished, path, failure);
    if (file && !failure) return;
    fs::remove(unfinished, failure);
    throw refusal(path, option, "cannot be written", "check permissions and free space");
}

}  // namespace runout
