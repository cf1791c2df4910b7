#include "report/text/time_table.h"

#include <fmt/format.h>

namespace runout {

std::string time_table(const std::vector<PhaseTime>& phases) {
    double whole = 0.0;
    for (const PhaseTime& phase : phases) whole += phase.wall_s;
    if (!(whole > 0.0)) return {};
    std::string text = fmt::format("{:<12}{:>9}{:>8}\n", "Time in", "s", "share");
    for (const PhaseTime& phase : phases) {
        text += fmt::format("{:<12}{:>9.3f}{:>6.0f} %\n", phase.phase, phase.wall_s,
                            100.0 * phase.wall_s / whole);
    }
    return text;
}

}  // namespace runout
