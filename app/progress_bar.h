// SPDX-License-Identifier: GPL-3.0-or-later
// Progress of long work, on a terminal and in a log.
#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <thread>

#include "core/text/handy_text.h"

namespace drillwave {

/// Time between the lines of a log.
inline constexpr std::chrono::seconds linesBetween{15};

/// "42 s", "3 min 20 s", "5 h 12 min".
std::string durationText(double seconds);

/// Output for the progress.
struct ProgressOutput {
    std::FILE* stream = stderr;
    std::chrono::milliseconds between = linesBetween;
};

/// Draws "[####    ] 41 %  520000/s  3 s left" on a terminal when the work lasts over a second. Elsewhere, in
/// the log of a job, a line "41 % done, 30 s left" after a second if the work takes over ten, and then now
/// and then.
class ProgressBar {
  public:
    /// `unit` names what is counted, "points"; empty where only the share is known.
    ProgressBar(std::uint64_t total, const Message& unit, const ReadingStyle& style,
                const ProgressOutput& out = {});
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void show(std::uint64_t done);

  private:
    using Clock = std::chrono::steady_clock;
    /// Estimates the time left [s] from the part that is done; not finite if nothing is.
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

/// A progress bar for work that reports a share.
class ShareBar {
  public:
    explicit ShareBar(const ReadingStyle& style) : m_bar(static_cast<std::uint64_t>(parts), {}, style) {}
    /// Takes the share, 0 … 1. The bar must outlive it.
    std::function<void(double)> progress() {
        return [this](double done) { m_bar.show(static_cast<std::uint64_t>(done * parts)); };
    }

  private:
    static constexpr double parts = 1000;  // finer than the bar is drawn
    ProgressBar m_bar;
};

/// Draws "solving for 3 s; Ctrl-C ends it" on stderr, when that is a terminal and work of unknown length
/// lasts over a second; elsewhere a line "solving for 15 s" now and then.
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
