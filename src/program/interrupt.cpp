#include "program/interrupt.h"

#include <cstdlib>
#include <ctime>

#include "program/command.h"

namespace runout {
namespace {

/// As under nohup, which must not end the run when the terminal closes.
bool is_ignored(int signal) {
    struct sigaction action {};
    return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

InterruptWatch::InterruptWatch() {
    sigemptyset(&signals_);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        if (!is_ignored(signal)) sigaddset(&signals_, signal);
    pthread_sigmask(SIG_BLOCK, &signals_, &before_);
    waiter_ = std::thread([this] { wait_for_signals(); });
}

InterruptWatch::~InterruptWatch() {
    finished_ = true;
    waiter_.join();
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void InterruptWatch::wait_for_signals() {
    const timespec tenth_of_a_second{.tv_sec = 0, .tv_nsec = 100'000'000};
    while (!finished_) {
        if (sigtimedwait(&signals_, nullptr, &tenth_of_a_second) < 0) continue;
        // The database is safe: a run is one transaction, and SQLite undoes what was not committed.
        if (requested_.exchange(true)) std::_Exit(exit_code::interrupted);
    }
}

}  // namespace runout
