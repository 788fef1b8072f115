// SPDX-License-Identifier: GPL-3.0-or-later
// Clock that measures how long a thread blocks its event loop, independent of other load on the machine.
#pragma once

#include <chrono>
#include <fstream>

namespace drillwave {

/// Returns wall time less the time for which the calling thread was ready but had no processor (on Linux;
/// elsewhere wall time). Computing, sleeping and waiting for other threads all count.
inline std::chrono::nanoseconds ownClock() {
    long long ran = 0;
    long long waitedForProcessor = 0;
    std::ifstream("/proc/thread-self/schedstat") >> ran >> waitedForProcessor;
    const auto wall = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::nanoseconds(wall) - std::chrono::nanoseconds(waitedForProcessor);
}

}  // namespace drillwave
