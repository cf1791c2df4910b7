#pragma once

#include <string>
#include <vector>

namespace runout {

/// From the least to the greatest of some numbers. Starts without any.
class AxisRange {
  public:
    void include(double value);
    [[nodiscard]] bool empty() const { return low_ > high_; }
    [[nodiscard]] double low() const { return low_; }
    [[nodiscard]] double high() const { return high_; }
    [[nodiscard]] double length() const { return high_ - low_; }
    /// The same middle, another length.
    [[nodiscard]] AxisRange widened_to(double length) const;

  private:
    double low_ = 1.0, high_ = -1.0;
};

/// One axis of a chart: what it spans and where numbers stand on it.
struct Axis {
    double low = 0.0, high = 1.0;
    bool logarithmic = false;
    std::vector<double> ticks;  ///< ascending, within the axis

    /// 0 at the low end, 1 at the high end.
    [[nodiscard]] double position(double value) const;
};

/// A range that an axis can span: never empty, never a single value.
AxisRange drawable(const AxisRange& data);

/// Ends at the ticks around the data. The distance of ticks is 1, 2 or 5 times a power of ten; there are
/// about `tick_count` of them.
Axis linear_axis(const AxisRange& data, int tick_count);

/// Spans just `range`, two ticks or more inside: for axes whose scale is given.
Axis fixed_axis(const AxisRange& range, int tick_count);

/// Decades; ticks at 1, 2 and 5 of each while there is room for them, else at decades alone. Data must be
/// positive.
Axis logarithmic_axis(const AxisRange& data, int tick_count);

/// Labels of the ticks, short, but with the digits that tell neighbours apart.
std::vector<std::string> tick_labels(const Axis& axis);

}  // namespace runout
