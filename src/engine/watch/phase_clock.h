#pragma once

#include <array>
#include <chrono>

namespace runout {

/// Parts of a step whose time is taken; `count` is how many there are.
enum class Phase { equilibrium, neighbours, friction, pressure, motion, judgement, count };

/// "equilibrium", "neighbours", ...; empty for `count`.
constexpr const char* to_string(Phase phase) {
    switch (phase) {
        case Phase::equilibrium:
            return "equilibrium";
        case Phase::neighbours:
            return "neighbours";
        case Phase::friction:
            return "friction";
        case Phase::pressure:
            return "pressure";
        case Phase::motion:
            return "motion";
        case Phase::judgement:
            return "judgement";
        case Phase::count:
            break;
    }
    return "";
}

/// Seconds at the clock that each phase of the steps took. Not for several threads at a time.
class PhaseClock {
  public:
    /// Ends the phase at hand, if any, and starts the next.
    void enter(Phase phase) {
        const auto now = std::chrono::steady_clock::now();
        if (current_ != Phase::count) seconds_[static_cast<int>(current_)] += elapsed(now);
        current_ = phase;
        since_ = now;
    }
    /// Ends the phase at hand.
    void leave() { enter(Phase::count); }
    /// In all the phases of this name that have ended, s.
    [[nodiscard]] double seconds(Phase phase) const { return seconds_[static_cast<int>(phase)]; }

  private:
    [[nodiscard]] double elapsed(std::chrono::steady_clock::time_point now) const {
        return std::chrono::duration<double>(now - since_).count();
    }

    std::array<double, static_cast<int>(Phase::count)> seconds_{};
    Phase current_ = Phase::count;
    std::chrono::steady_clock::time_point since_;
};

/// Adds the seconds of its life at the clock to a sum.
class Stopwatch {
  public:
    /// `seconds`: the sum, s, which must live longer.
    explicit Stopwatch(double& seconds) : seconds_(seconds), start_(std::chrono::steady_clock::now()) {}
    ~Stopwatch() {
        seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

  private:
    double& seconds_;
    std::chrono::steady_clock::time_point start_;
};

}  // namespace runout
