#include "core/version.h"

#include "core/revision.h"

namespace runout {

std::string program_version() {
    return build::version;
}

std::string program_revision() {
    return build::revision;
}

std::string compiler_description() {
    return build::compiler;
}

}  // namespace runout
