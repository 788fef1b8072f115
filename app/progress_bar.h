// SPDX-License-Identifier: GPL-3.0-or-later
// How far long work is, on a terminal.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string_view>
#include <thread>

namespace drillwave {

/// Draws "[####    ] 41 %  520000/s  3 s left" on stderr, when that is a terminal and the work lasts over a
/// second.
class ProgressBar {
  public:
    /// `unit` names what is counted, "points"; empty where only the share is known.
    explicit ProgressBar(std::uint64_t total, std::string_view unit = {});
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void show(std::uint64_t done);

  private:
    using Clock = std::chrono::steady_clock;
    std::uint64_t m_total;
    std::string_view m_unit;
    bool m_isTerminal;
    bool m_drawn = false;
    Clock::time_point m_start = Clock::now();
    Clock::time_point m_nextDrawing = m_start + std::chrono::seconds(1);
};

/// The same for work that tells what share of it is done.
class ShareBar {
  public:
    /// Takes the share, 0 … 1. The bar must outlive it.
    std::function<void(double)> progress() {
        return [this](double done) { m_bar.show(static_cast<std::uint64_t>(done * parts)); };
    }

  private:
    static constexpr double parts = 1000;  // finer than the bar is drawn
    ProgressBar m_bar{static_cast<std::uint64_t>(parts)};
};

/// Draws "solving for 3 s; Ctrl-C ends it" on stderr, when that is a terminal and the work, whose end nobody
/// can tell, lasts over a second.
class ElapsedTime {
  public:
    ElapsedTime();
    ~ElapsedTime();
    ElapsedTime(const ElapsedTime&) = delete;
    ElapsedTime& operator=(const ElapsedTime&) = delete;

  private:
    std::jthread m_drawing;
};

}  // namespace drillwave
