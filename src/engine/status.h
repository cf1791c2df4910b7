#pragma once

#include <string_view>

namespace runout {

/// How a run ended, or that it has not.
enum class RunStatus {
    running,        ///< not yet
    settled,        ///< came to rest by the engine's own criterion
    stable,         ///< came to rest without any particle having moved by two spacings: the source stands
    time_limit,     ///< still moving at the time limit
    left_section,   ///< soil reached an end of the section
    not_converged,  ///< the pressure equation did not reach its tolerance
    diverged,       ///< an invariant of the physics was violated
    interrupted,    ///< stopped by the user
    not_a_body,     ///< came to rest as spray, or thinner than what counts as a front: said by who reads it
};

/// The word stored and printed: "settled", "time_limit", ... "unknown" for what is none of them.
constexpr std::string_view to_string(RunStatus status) {
    switch (status) {
        case RunStatus::running:
            return "running";
        case RunStatus::settled:
            return "settled";
        case RunStatus::stable:
            return "stable";
        case RunStatus::time_limit:
            return "time_limit";
        case RunStatus::left_section:
            return "left_section";
        case RunStatus::not_converged:
            return "not_converged";
        case RunStatus::diverged:
            return "diverged";
        case RunStatus::interrupted:
            return "interrupted";
        case RunStatus::not_a_body:
            return "not_a_body";
    }
    return "unknown";
}

/// Whether it is that of a run whose numbers may stand in a table: settled or stable.
constexpr bool is_result(RunStatus status) {
    return status == RunStatus::settled || status == RunStatus::stable;
}

}  // namespace runout
