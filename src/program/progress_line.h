#pragma once

#include <string>

#include "run/run_scene.h"

namespace runout {

/// Tells on standard error how far a run has come: a bar with the time left on a terminal, a line for every
/// tenth of the way otherwise.
class ProgressLine {
  public:
    enum class Style { bar, lines, none };
    explicit ProgressLine(Style style) : style_(style) {}

    /// Bar on a terminal, lines elsewhere.
    static Style style_of_stderr();

    void show(const Progress& progress);
    /// Leaves the terminal's cursor on an empty line.
    void finish();

  private:
    Style style_;
    int tenths_shown_ = 0;
    bool bar_is_drawn_ = false;
};

/// "12 s", "3 min 20 s", "2 h 5 min".
std::string duration_text(double seconds);

}  // namespace runout
