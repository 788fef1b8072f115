// SPDX-License-Identifier: GPL-3.0-or-later
// A clock for how long a thread keeps its event loop waiting, whatever else the machine is busy with.
#pragma once

#include <chrono>
#include <fstream>

namespace drillwave {

/// Wall time less the time in which the calling thread wanted to run and got no processor (Linux; elsewhere
/// wall time). Computing, sleeping and waiting for other threads all count.
inline std::chrono::nanoseconds ownClock() {
    long long ran = 0;
    long long waitedForProcessor = 0;
    std::ifstream("/proc/thread-self/schedstat") >> ran >> waitedForProcessor;
    const auto wall = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::nanoseconds(wall) - std::chrono::nanoseconds(waitedForProcessor);
}

}  // namespace drillwave
