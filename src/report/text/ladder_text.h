#pragma once

#include <span>
#include <string>
#include <vector>

#include "accuracy/ladder.h"
#include "accuracy/methods.h"
#include "accuracy/price.h"
#include "core/figure.h"

namespace runout {

/// The head of the table that a ladder prints as it goes: titles and units.
std::string rung_table_head();

/// One line of it; `before`: the rung before, or null.
std::string rung_table_line(const RungSummary& rung, const RungSummary* before);

/// What stands below the table when the ladder has ended: every rung against the finest, what the ladder says
/// of each quantity, and the price list.
std::string ladder_summary(const Ladder& ladder, std::span<const Price> prices);

/// One line for a setting of a method, and the head above them.
std::string method_table_head();
std::string method_table_line(const MethodPoint& point);

/// Error against CPU time on logarithmic axes, one line for each series.
Figure work_precision_figure(const std::string& name, const std::string& title,
                             const std::vector<MethodPoint>& points);

/// A ladder with its prices and the methods compared, as one JSON object.
std::string ladder_json(const std::string& name, const Ladder& ladder, std::span<const Price> prices,
                        std::span<const MethodPoint> points);

/// "2 s", "0.05 s", "3 min": two digits, for people.
std::string short_duration(double seconds);

}  // namespace runout
