#include "gis/virtual_sources.h"

#include <cpl_minixml.h>
#include <cpl_string.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "core/input_error.h"
#include "gis/network.h"

namespace runout {
namespace {

namespace fs = std::filesystem;

constexpr int deepest_nesting = 8;
constexpr const char* valid =
    "copy the sources beside it and name them relative to it, or give --allow-network if you trust the file";

/// Elements, attributes and keys of metadata whose value names a file.
constexpr std::array<std::string_view, 9> naming = {"SourceFilename", "SourceDataset", "SrcDataSource",
                                                    "X_DATASET",      "Y_DATASET",     "RPC_DEM",
                                                    "RPC_DEMPATH",    "SrcDSName",     "CutlineDataset"};
/// What would let the file compute instead of refer.
constexpr std::array<std::string_view, 3> computing = {"SrcSQL", "PixelFunctionCode", "SQLStatement"};

template <std::size_t count>
bool is_one_of(const std::array<std::string_view, count>& names, std::string_view name) {
    return std::ranges::any_of(names, [&](std::string_view known) {
        return EQUALN(known.data(), name.data(), known.size()) && known.size() == name.size();
    });
}

/// The name under which a value stands: of `<MDI key="X_DATASET">` the key.
std::string name_of(const CPLXMLNode* node) {
    const char* key = CPLGetXMLValue(node, "key", nullptr);
    if (key == nullptr) key = CPLGetXMLValue(node, "name", nullptr);
    const bool keyed = EQUAL(node->pszValue, "MDI") || EQUAL(node->pszValue, "Option");
    return keyed && key != nullptr ? key : node->pszValue;
}

class SourceCheck {
  public:
    explicit SourceCheck(std::string path) : path_(std::move(path)) {
        std::error_code ignored;
        folder_ = fs::weakly_canonical(fs::absolute(path_).parent_path(), ignored);
    }

    void check(const CPLXMLNode* node, int depth) const {
        for (; node != nullptr; node = node->psNext) {
            if (node->eType != CXT_Element && node->eType != CXT_Attribute) continue;
            const std::string name = name_of(node);
            if (is_one_of(computing, name)) refuse(name, "", "lets the file compute what it holds");
            if (is_one_of(naming, name)) check_source(node, name, depth);
            check(node->psChild, depth);
        }
    }

  private:
    [[noreturn]] void refuse(const std::string& name, const std::string& value,
                             const std::string& problem) const {
        throw InputError({path_, 0, name, value}, problem, valid);
    }

    void check_source(const CPLXMLNode* node, const std::string& name, int depth) const {
        const std::string value = CPLGetXMLValue(node, "", "");
        if (value.empty()) return;
        if (is_remote(value)) refuse(name, value, "is not a file on this machine");
        const bool beside = CPLTestBool(CPLGetXMLValue(node, "relativeToVRT", "0"));
        std::error_code ignored;
        const fs::path source = fs::weakly_canonical(beside ? folder_ / value : fs::absolute(value), ignored);
        const auto [folder_end, end] =
            std::mismatch(folder_.begin(), folder_.end(), source.begin(), source.end());
        if (folder_end != folder_.end()) refuse(name, value, "lies outside the folder of the file");
        if (!fs::is_regular_file(source, ignored) && !fs::is_directory(source, ignored))
            refuse(name, value, "is not a file");
        check_nested(source.string(), name, depth);
    }

    void check_nested(const std::string& source, const std::string& name, int depth) const;

    std::string path_;
    fs::path folder_;
};

bool is_virtual(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    std::string head(2048, '\0');
    stream.read(head.data(), static_cast<std::streamsize>(head.size()));
    return head.find("<VRTDataset") != std::string::npos ||
           head.find("<OGRVRTDataSource") != std::string::npos;
}

void check_file(const std::string& path, int depth) {
    const CPLXMLTreeCloser tree(CPLParseXMLFile(path.c_str()));
    if (!tree) throw InputError({path, 0, "", ""}, "is not valid XML", "make it anew with gdalbuildvrt");
    SourceCheck(path).check(tree.get(), depth);
}

void SourceCheck::check_nested(const std::string& source, const std::string& name, int depth) const {
    if (!is_virtual(source)) return;
    if (depth >= deepest_nesting) refuse(name, source, "is a virtual file within too many others");
    check_file(source, depth + 1);
}

}  // namespace

void check_virtual_sources(const std::string& path) {
    check_file(path, 0);
}

}  // namespace runout
