#pragma once

#include <atomic>
#include <csignal>
#include <thread>

namespace runout {

/// While it lives, Ctrl-C, SIGTERM and a terminal that closes (SIGHUP) ask for an orderly end in place of
/// killing the program; a second one kills. What the program was started to ignore stays ignored.
///
/// The signals are blocked and waited for by a thread, so there is no signal handler and nothing global. Make
/// it before other threads start: they inherit the blocked signals.
class InterruptWatch {
  public:
    InterruptWatch();
    ~InterruptWatch();
    InterruptWatch(const InterruptWatch&) = delete;
    InterruptWatch& operator=(const InterruptWatch&) = delete;

    [[nodiscard]] const std::atomic<bool>& requested() const { return requested_; }

  private:
    void wait_for_signals();

    std::atomic<bool> requested_ = false;
    std::atomic<bool> finished_ = false;
    sigset_t signals_{};
    sigset_t before_{};
    std::thread waiter_;
};

}  // namespace runout
