#include "validation/entry.h"

#include <cmath>

namespace runout {

double deviation(const ValidationEntry& entry) {
    switch (entry.kind) {
        case DeviationKind::relative:
            return entry.computed / entry.reference - 1.0;
        case DeviationKind::absolute:
            return entry.computed - entry.reference;
        case DeviationKind::at_most:
            break;
    }
    return entry.computed;
}

bool within_band(const ValidationEntry& entry) {
    if (std::isnan(entry.accepted)) return true;
    const double off = deviation(entry);
    return entry.kind == DeviationKind::at_most ? off <= entry.accepted : std::abs(off) <= entry.accepted;
}

}  // namespace runout
