// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <string>
#include <system_error>

namespace drillwave {

namespace {

std::string duration(double seconds) {
    const auto whole = static_cast<std::uint64_t>(std::min(seconds, 1e9) + 0.5);
    if (whole < 60) return std::to_string(whole) + " s";
    if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
    return std::to_string(whole / 3600) + " h " + std::to_string(whole / 60 % 60) + " min";
}

}  // namespace

ProgressBar::ProgressBar(std::uint64_t total, std::string_view unit)
    : m_total(total), m_unit(unit), m_isTerminal(::isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
    if (m_drawn) std::fputs("\r\033[K", stderr);
}

void ProgressBar::show(std::uint64_t done) {
    if (!m_isTerminal || m_total == 0) return;
    const Clock::time_point now = Clock::now();
    if (now < m_nextDrawing) return;
    m_nextDrawing = now + std::chrono::milliseconds(200);
    m_drawn = true;

    constexpr std::size_t width = 30;
    const double share = static_cast<double>(done) / static_cast<double>(m_total);
    const double elapsed = std::chrono::duration<double>(now - m_start).count();
    const double rate = static_cast<double>(done) / elapsed;
    const auto filled = static_cast<std::size_t>(share * width);
    std::string bar = "\r\033[K[" + std::string(filled, '#') + std::string(width - filled, ' ') + "] " +
                      std::to_string(static_cast<int>(share * 100)) + " %";
    if (!m_unit.empty())
        bar += "  " + std::to_string(static_cast<std::uint64_t>(rate)) + " " + std::string(m_unit) + "/s";
    if (rate > 0) bar += "  " + duration(static_cast<double>(m_total - done) / rate) + " left";
    std::fputs(bar.c_str(), stderr);
}

ElapsedTime::ElapsedTime() {
    if (::isatty(STDERR_FILENO) != 1) return;
    const auto draw = [](const std::stop_token& stop) {
        std::mutex mutex;
        std::condition_variable_any stopped;
        std::unique_lock lock(mutex);
        bool drawn = false;
        for (int seconds = 1;; ++seconds) {
            stopped.wait_for(lock, stop, std::chrono::seconds(1), [] { return false; });
            if (stop.stop_requested()) break;
            drawn = true;
            std::fprintf(stderr, "\r\033[Ksolving for %s; Ctrl-C ends it", duration(seconds).c_str());
        }
        if (drawn) std::fputs("\r\033[K", stderr);
    };
    try {
        m_drawing = std::jthread(draw);
    } catch (const std::system_error&) {
        // No thread is left: the work goes on unseen.
    }
}

ElapsedTime::~ElapsedTime() = default;

}  // namespace drillwave
