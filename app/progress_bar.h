// SPDX-License-Identifier: GPL-3.0-or-later
// Progress of long computations, on a terminal and in a log.
#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <thread>

#include "core/text/handy_text.h"

namespace drillwave {

/// Time between two progress lines in a log.
inline constexpr std::chrono::seconds linesBetween{15};

/// Returns a duration rounded to seconds or minutes: "42 s", "3 min 20 s", "5 h 12 min".
std::string durationText(double seconds);

/// Output of a progress display: the stream, and the time between two lines if the stream is not a terminal.
struct ProgressOutput {
    std::FILE* stream = stderr;
    std::chrono::milliseconds between = linesBetween;
};

/// Progress display of computations that last over a second. A terminal shows "[####    ] 41 %  520000/s  3 s
/// left". Elsewhere, as in the log of a job, lines "41 % done, 30 s left" appear at intervals. The first one
/// appears after a second if more than ten seconds are left.
class ProgressBar {
  public:
    /// Starts the display for `total` units of work. `unit` is their name, such as "points". If it is empty,
    /// no rate is shown.
    ProgressBar(std::uint64_t total, const Message& unit, const ReadingStyle& style,
                const ProgressOutput& out = {});
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void show(std::uint64_t done);

  private:
    using Clock = std::chrono::steady_clock;
    /// Returns the estimated remaining time [s] when `done` units are complete; not finite for 0.
    double secondsLeft(std::uint64_t done) const;
    std::string numbers(std::uint64_t done) const;

    std::uint64_t m_total;
    std::string m_unit;
    const ReadingStyle& m_style;
    ProgressOutput m_out;
    bool m_isTerminal;
    bool m_drawn = false;
    Clock::time_point m_start = Clock::now();
    Clock::time_point m_nextDrawing;
};

/// Progress bar for work that reports its progress as a share from 0 to 1.
class ShareBar {
  public:
    explicit ShareBar(const ReadingStyle& style) : m_bar(static_cast<std::uint64_t>(parts), {}, style) {}
    /// Returns a function that shows the completed share, 0 … 1. This object must outlive the function.
    std::function<void(double)> progress() {
        return [this](double done) { m_bar.show(static_cast<std::uint64_t>(done * parts)); };
    }

  private:
    static constexpr double parts = 1000;  // units of work for a share of 1; finer than the bar is drawn
    ProgressBar m_bar;
};

/// Display of the elapsed time for work of unknown length that lasts over a second. A terminal shows "solving
/// for 3 s; Ctrl-C ends it". If stderr is not a terminal, a line "solving for 15 s" is printed every 15 s.
class ElapsedTime {
  public:
    explicit ElapsedTime(const ReadingStyle& style);
    ~ElapsedTime();
    ElapsedTime(const ElapsedTime&) = delete;
    ElapsedTime& operator=(const ElapsedTime&) = delete;

  private:
    std::jthread m_drawing;
};

}  // namespace drillwave
