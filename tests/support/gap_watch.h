// SPDX-License-Identifier: GPL-3.0-or-later
// Measurement of how long an event loop blocks the rest of the program.
#pragma once

#include <algorithm>
#include <chrono>
#include <utility>

#include "tests/support/own_clock.h"

namespace drillwave {

/// Longest time between two turns of the event loop, measured by calling turn() from a timer of 1 ms.
struct GapWatch {
    using Milliseconds = std::chrono::duration<double, std::milli>;
    std::chrono::nanoseconds own = ownClock();
    std::chrono::steady_clock::time_point wall = std::chrono::steady_clock::now();
    Milliseconds longestOwn{0};
    Milliseconds longestWall{0};

    void turn() {
        const auto ownNow = ownClock();
        const auto wallNow = std::chrono::steady_clock::now();
        longestOwn = std::max(longestOwn, Milliseconds(ownNow - std::exchange(own, ownNow)));
        longestWall = std::max(longestWall, Milliseconds(wallNow - std::exchange(wall, wallNow)));
    }
};

}  // namespace drillwave
