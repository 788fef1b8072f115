// SPDX-License-Identifier: GPL-3.0-or-later
// Measurement of the processor time of a function, little disturbed by other work on the machine.
#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>
#include <stop_token>
#include <vector>

namespace drillwave {

/// Wall clock time in seconds since this object was made.
class Stopwatch {
  public:
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
    }

  private:
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

/// Processor time of one run in seconds, as median and minimum of several runs after a warm-up. Only the time
/// of this thread counts, so that other work on the machine has little effect.
struct RunTime {
    double median = 0;
    double least = 0;
    int runs = 0;  ///< number of runs: 11, fewer if one takes over a second
};

inline constexpr int wantedRuns = 11;

/// Returns the processor time that this thread has used so far, in seconds.
inline double threadSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Returns the processor time of work(), which has already run once and took about `estimate` seconds. Short
/// work is repeated within a run until a run takes 1 ms. Calls onRun() after each run. A stop request ends
/// the measurement early.
template <class Work, class OnRun>
RunTime measureRunTime(Work work, double estimate, const std::stop_token& stop, OnRun onRun) {
    constexpr double resolved = 1e-3;  // s
    const auto batch = [&](long count) {
        const double start = threadSeconds();
        for (long i = 0; i < count; ++i) work();
        return threadSeconds() - start;
    };
    long count = 1;
    if (estimate < resolved)
        while (batch(count) < resolved && !stop.stop_requested()) count *= 2;
    const int runs = estimate > 10 ? 1 : estimate > 1 ? 3 : wantedRuns;
    std::vector<double> seconds;
    while (static_cast<int>(seconds.size()) < runs && !stop.stop_requested()) {
        seconds.push_back(batch(count) / static_cast<double>(count));
        onRun();
    }
    if (seconds.empty()) return {};
    std::ranges::sort(seconds);
    return {.median = seconds[seconds.size() / 2],
            .least = seconds.front(),
            .runs = static_cast<int>(seconds.size())};
}

}  // namespace drillwave
