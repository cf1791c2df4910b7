#include "program/patient_store.h"

#include <chrono>
#include <memory>

#include "program/log.h"

namespace runout {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds one_try{1};
constexpr std::chrono::seconds between_messages{10};

}  // namespace

void wait_for_others(Store& store, const std::string& path, const std::atomic<bool>& interrupt) {
    store.set_patience(one_try);
    store.set_on_wait([path, &interrupt, next_message = Clock::time_point{}]() mutable {
        if (interrupt) return false;
        if (Clock::now() >= next_message) {
            next_message = Clock::now() + between_messages;
            log_error("{} is in use by another program; what has ended waits for it; Ctrl-C gives it up",
                      path);
        }
        return true;
    });
}

}  // namespace runout
