#include "gis/network.h"

#include <cpl_conv.h>
#include <cpl_http.h>
#include <cpl_string.h>
#include <cpl_vsi_virtual.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <set>
#include <string_view>

namespace runout {
namespace {

constexpr const char* closed_text = "network access is off; --allow-network turns it on";

/// Archives on the disk, and memory, which drivers use by themselves.
constexpr std::array<std::string_view, 5> local_systems = {"/vsimem/", "/vsizip/", "/vsitar/", "/vsigzip/",
                                                           "/vsisubfile/"};

bool is_local(std::string_view prefix) {
    return std::ranges::find(local_systems, prefix) != local_systems.end();
}

/// Has no file and says why.
class ClosedFileSystem : public VSIFilesystemHandler {
  public:
    VSIVirtualHandle* Open(const char* /*path*/, const char* /*access*/, bool /*set_error*/,
                           CSLConstList /*options*/) override {
        CPLError(CE_Failure, CPLE_OpenFailed, "%s", closed_text);
        errno = EACCES;
        return nullptr;
    }
    int Stat(const char* /*path*/, VSIStatBufL* /*found*/, int /*flags*/) override { return -1; }
};

CPLHTTPResult* refuse_request(const char* /*url*/, CSLConstList /*options*/, GDALProgressFunc /*progress*/,
                              void* /*progress_data*/, CPLHTTPFetchWriteFunc /*write*/, void* /*write_data*/,
                              void* /*user_data*/) {
    auto* result = static_cast<CPLHTTPResult*>(CPLCalloc(1, sizeof(CPLHTTPResult)));
    result->nStatus = 1;
    result->pszErrBuf = CPLStrdup(closed_text);
    CPLError(CE_Failure, CPLE_HttpResponse, "%s", closed_text);
    return result;
}

std::atomic<bool>& allowed() {
    static std::atomic<bool> network_allowed{false};
    return network_allowed;
}

}  // namespace

void allow_network() {
    allowed() = true;
}

bool network_is_allowed() {
    return allowed();
}

void close_network() {
    const CPLStringList prefixes(VSIFileManager::GetPrefixes());
    auto* const closed = new ClosedFileSystem;  // GDAL's, for as long as the program runs
    // GDAL would forget what it had there and never free it. Some of them serve several prefixes.
    static auto* const displaced = new std::set<VSIFilesystemHandler*>;
    for (int i = 0; i < prefixes.size(); ++i) {
        const char* const prefix = prefixes[i];
        if (is_local(prefix)) continue;
        displaced->insert(VSIFileManager::GetHandler(prefix));
        VSIFileManager::InstallHandler(prefix, closed);
    }
    CPLHTTPSetFetchCallback(refuse_request, nullptr);
}

bool is_remote(const std::string& path) {
    std::string_view rest = path;
    for (bool goes_on = true; goes_on;) {
        goes_on = false;
        for (const std::string_view prefix : local_systems)
            if (rest.starts_with(prefix)) {
                rest.remove_prefix(prefix.size());
                if (rest.starts_with('{')) rest.remove_prefix(1);  // an archive within one
                goes_on = true;
            }
    }
    const std::size_t scheme = rest.find("://");
    const bool is_address = scheme != std::string_view::npos && rest.find('/') > scheme;
    return rest.starts_with("/vsi") || is_address;
}

}  // namespace runout
