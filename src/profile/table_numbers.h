#pragma once

#include <optional>
#include <string_view>

namespace runout {

enum class DecimalMark { point, comma };

/// What a cell says about the decimal mark of its table.
enum class MarkEvidence {
    no_number,           ///< it is none with either mark
    none,                ///< 1234
    point,               ///< 3.5, 1,234.5
    comma,               ///< 3,5, 1.234,5
    point_or_thousands,  ///< 1.234
    comma_or_thousands   ///< 1,234
};
MarkEvidence mark_evidence(std::string_view cell);

/// The other mark stands between thousands for certain: 1,234.5 or 1,234,567.
bool proves_thousands(std::string_view cell);

/// The number of a cell: a sign, digits, perhaps with a mark between thousands (the other mark, a blank, an
/// apostrophe), a decimal part, an exponent. None where it is not one, or not finite.
std::optional<double> number_of(std::string_view cell, DecimalMark mark);

/// A chainage such as 12+50.25 or "Km 1+234.5".
struct StationText {
    std::string_view sign{};
    std::string_view before{};  ///< digits before the plus
    std::string_view after{};   ///< what follows it: digits, perhaps with a decimal part
    int digits_after = 0;       ///< before the decimal mark: 2 or 3
};
std::optional<StationText> station_text(std::string_view cell);

/// The cell says that there is no value: empty, `-`, `*`, NaN, null, `#N/A`, "no data" ...
bool says_nothing(std::string_view cell);

/// A number by which programs mark missing elevations: -9999, -32768, 1e20 ...
bool is_nodata_number(double value);

}  // namespace runout
