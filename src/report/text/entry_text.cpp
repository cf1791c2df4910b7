#include "report/text/entry_text.h"

#include <fmt/format.h>

#include <cmath>

namespace runout {

std::string number_text(double value) {
    return std::isfinite(value) ? fmt::format("{:.4g}", value + 0.0) : "-";
}

std::string deviation_text(const ValidationEntry& entry) {
    const double off = deviation(entry) + 0.0;  // no negative zero
    if (!std::isfinite(off)) return "-";
    switch (entry.kind) {
        case DeviationKind::relative:
            return fmt::format("{:+.4g} %", 100.0 * off);
        case DeviationKind::absolute:
            return fmt::format("{:+.4g}", off);
        case DeviationKind::at_most:
            break;
    }
    return number_text(off);
}

std::string accepted_text(const ValidationEntry& entry) {
    if (!is_judged(entry)) return "-";
    switch (entry.kind) {
        case DeviationKind::relative:
            return fmt::format("+-{:.4g} %", 100.0 * entry.accepted);
        case DeviationKind::absolute:
            return "+-" + number_text(entry.accepted);
        case DeviationKind::at_most:
            break;
    }
    return "<= " + number_text(entry.accepted);
}

std::string computed_text(const ValidationEntry& entry) {
    return std::isfinite(entry.computed) ? number_text(entry.computed) : "no result";
}

std::string verdict_text(const ValidationEntry& entry) {
    if (!is_judged(entry)) return "-";
    return is_outside(entry) ? "OUTSIDE" : "pass";
}

bool is_judged(const ValidationEntry& entry) {
    return !std::isnan(entry.accepted);
}

bool is_outside(const ValidationEntry& entry) {
    return is_judged(entry) && !within_band(entry);
}

std::string counts_text(std::span<const CaseReport> reports) {
    int judged = 0, outside = 0, entries = 0;
    for (const CaseReport& report : reports)
        for (const ValidationEntry& entry : report.entries) {
            ++entries;
            judged += is_judged(entry) ? 1 : 0;
            outside += is_outside(entry) ? 1 : 0;
        }
    return fmt::format("{} entries judged: {} within their band, {} outside; {} reported without a band",
                       judged, judged - outside, outside, entries - judged);
}

}  // namespace runout
