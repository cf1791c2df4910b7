#include "core/length_unit.h"

#include "core/input_error.h"

namespace runout {

LengthUnit known_length_unit(std::string_view word) {
    if (const auto unit = length_unit(word)) return *unit;
    throw InputError({"", 0, "section.unit", std::string(word)}, "is not a known unit",
                     "give m, cm, mm, ft, us-ft or in");
}

}  // namespace runout
