#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "core/input_error.h"

// What is said of wrong input.

namespace runout {

/// The sentence of the InputError that `action` throws; empty when it throws none.
inline std::string input_error(const std::function<void()>& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

inline testing::AssertionResult contains(const std::string& text, const std::string& part) {
    if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
    return testing::AssertionFailure() << '"' << text << "\" does not contain \"" << part << '"';
}

}  // namespace runout
