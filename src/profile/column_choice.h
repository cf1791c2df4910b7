#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/input_error.h"
#include "profile/column_names.h"

namespace runout {

/// Index of the column of chainages, and of that of elevations.
using ColumnPair = std::pair<std::size_t, std::size_t>;

/// What the user says of the columns: two names, or two numbers.
struct ColumnWish {
    std::string chainage{};
    std::string elevation{};
    std::optional<ColumnPair> numbers{};  ///< 0-based

    [[nodiscard]] bool given() const { return !chainage.empty(); }
};

/// Reads "Station,Elev" or "3,5"; empty text is no wish. Throws InputError.
ColumnWish column_wish(const std::string& text, const std::string& path);

/// The two columns that a header names. None: it does not name both. Throws InputError, at `place`, where the
/// names leave a choice, or name coordinates on a map and no chainage.
std::optional<ColumnPair> named_columns(const std::vector<ColumnName>& names, const ColumnWish& wish,
                                        const InputPlace& place);

/// "'Station', 'Elev', 'Code'" for a message, the first of them.
std::string listed_names(const std::vector<ColumnName>& names);

}  // namespace runout
