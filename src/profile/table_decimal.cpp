#include "profile/table_decimal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/input_error.h"
#include "profile/check_elevations.h"

namespace runout {
namespace {

// A section of a slope is no longer. Elevations bound the other side of the guess.
constexpr double longest_section = 20000;
constexpr double metres_of_a_foot = 0.3048;

constexpr const char* say_the_mark = "say which: --decimal point or --decimal comma (section.decimal)";

struct Seen {
    int line = 0;
    std::string text;
};

/// The first cell of each kind.
struct Evidence {
    std::optional<Seen> point;
    std::optional<Seen> comma;
    std::optional<Seen> point_or_thousands;
    std::optional<Seen> comma_or_thousands;
    std::optional<Seen> thousands;  ///< proven

    void see(std::string_view cell, int line) {
        if (const auto station = station_text(cell)) {
            see_station(*station, line);
            return;
        }
        const auto note = [&](std::optional<Seen>& first) {
            if (!first) first = Seen{line, std::string(cell)};
        };
        switch (mark_evidence(cell)) {
            case MarkEvidence::point:
                note(point);
                break;
            case MarkEvidence::comma:
                note(comma);
                break;
            case MarkEvidence::point_or_thousands:
                note(point_or_thousands);
                return;
            case MarkEvidence::comma_or_thousands:
                note(comma_or_thousands);
                return;
            case MarkEvidence::none:
            case MarkEvidence::no_number:
                return;
        }
        if (proves_thousands(cell)) note(thousands);
    }

  private:
    /// No station has thousands.
    void see_station(const StationText& station, int line) {
        const auto note = [&](std::optional<Seen>& first) {
            if (!first) first = Seen{line, std::string(station.after)};
        };
        if (station.after.find('.') != std::string_view::npos) note(point);
        if (station.after.find(',') != std::string_view::npos) note(comma);
    }
};

[[noreturn]] void refuse(const Seen& seen, const std::string& problem, const std::string& path) {
    throw InputError({path, seen.line, "number", seen.text}, problem, say_the_mark);
}

/// Whether the numbers would make a section if their marks stood between thousands.
bool could_be_thousands(const std::vector<PointCells>& points, DecimalMark other) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const PointCells& point : points) {
        if (const auto chainage = number_of(point.chainage, other)) {
            low = std::min(low, *chainage);
            high = std::max(high, *chainage);
        }
        const auto elevation = number_of(point.elevation, other);
        if (elevation && !is_nodata_number(*elevation) &&
            (*elevation < lowest_ground_m || *elevation > highest_ground_m / metres_of_a_foot))
            return false;
    }
    return high - low <= longest_section;
}

}  // namespace

DecimalMark decimal_mark_of(const std::vector<PointCells>& points, Separator separator,
                            const std::string& path) {
    Evidence seen;
    for (const PointCells& point : points) {
        seen.see(point.chainage, point.line);
        seen.see(point.elevation, point.line);
    }
    if (seen.point && seen.comma)
        refuse(seen.point->line > seen.comma->line ? *seen.point : *seen.comma,
               fmt::format("has another decimal mark than {} in line {}",
                           seen.point->line > seen.comma->line ? seen.comma->text : seen.point->text,
                           std::min(seen.point->line, seen.comma->line)),
               path);
    const bool certain = seen.point || seen.comma;
    const DecimalMark mark =
        seen.comma || (!certain && seen.comma_or_thousands) ? DecimalMark::comma : DecimalMark::point;
    // Of 1.234 and 1,234: the cells that have this mark, and those that have the other one.
    const auto& with_mark = mark == DecimalMark::point ? seen.point_or_thousands : seen.comma_or_thousands;
    const auto& with_other = mark == DecimalMark::point ? seen.comma_or_thousands : seen.point_or_thousands;
    const DecimalMark other = mark == DecimalMark::point ? DecimalMark::comma : DecimalMark::point;
    if (with_other && !(certain && seen.thousands))
        refuse(*with_other, "may have thousands or decimals behind its mark", path);
    // Nobody who writes decimal commas separates by commas.
    const bool settled = certain || (mark == DecimalMark::point && separator == Separator::comma);
    if (with_mark && !settled && could_be_thousands(points, other))
        refuse(*with_mark, "may have thousands or decimals behind its mark", path);
    return mark;
}

}  // namespace runout
