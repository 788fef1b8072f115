// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <string>
#include <system_error>

namespace drillwave {

namespace {

/// Work that takes longer has its first line in a log after a second [s].
constexpr double worthTelling = 10;

}  // namespace

std::string durationText(double seconds) {
    const auto whole = std::llround(std::min(seconds, 1e9));
    if (whole < 60) return std::to_string(whole) + " s";
    if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
    return std::to_string(whole / 3600) + " h " + std::to_string(whole / 60 % 60) + " min";
}

ProgressBar::ProgressBar(std::uint64_t total, const Message& unit, const ReadingStyle& style,
                         const ProgressOutput& out)
    : m_total(total),
      m_unit(style.said(unit)),
      m_style(style),
      m_out(out),
      m_isTerminal(::isatty(::fileno(out.stream)) == 1),
      m_nextDrawing(m_start + std::min<Clock::duration>(std::chrono::seconds(1), out.between)) {}

ProgressBar::~ProgressBar() {
    if (m_drawn) std::fputs("\r\033[K", m_out.stream);
}

void ProgressBar::show(std::uint64_t done) {
    if (m_total == 0) return;
    const Clock::time_point now = Clock::now();
    if (now < m_nextDrawing) return;
    if (!m_isTerminal && now < m_start + m_out.between && !(secondsLeft(done) > worthTelling)) {
        m_nextDrawing = now + std::min<Clock::duration>(std::chrono::seconds(1), m_out.between);
        return;
    }
    m_nextDrawing = now + (m_isTerminal ? std::chrono::milliseconds(200) : m_out.between);
    const double share = static_cast<double>(done) / static_cast<double>(m_total);
    const std::string percent = std::to_string(static_cast<int>(share * 100)) + " %";
    std::string text;
    if (m_isTerminal) {
        constexpr std::size_t width = 30;
        const auto filled = static_cast<std::size_t>(share * width);
        text = "\r\033[K[" + std::string(filled, '#') + std::string(width - filled, ' ') + "] " + percent +
               numbers(done);
        m_drawn = true;
    } else {
        text = m_style.said({translatable("%1 done"), {percent}}) + numbers(done) + "\n";
    }
    std::fputs(text.c_str(), m_out.stream);
}

std::string ProgressBar::numbers(std::uint64_t done) const {
    std::string text;
    const double elapsed = std::chrono::duration<double>(Clock::now() - m_start).count();
    const double rate = static_cast<double>(done) / elapsed;
    if (!m_unit.empty())
        text += "  " + std::to_string(static_cast<std::uint64_t>(rate)) + " " + m_unit + "/s";
    if (rate > 0) text += "  " + m_style.said({translatable("%1 left"), {durationText(secondsLeft(done))}});
    return text;
}

double ProgressBar::secondsLeft(std::uint64_t done) const {
    const double elapsed = std::chrono::duration<double>(Clock::now() - m_start).count();
    return elapsed * static_cast<double>(m_total - std::min(done, m_total)) / static_cast<double>(done);
}

ElapsedTime::ElapsedTime(const ReadingStyle& style) {
    const bool isTerminal = ::isatty(STDERR_FILENO) == 1;
    // Styles are not for several threads at once.
    const std::string words = style.patternFor(isTerminal ? translatable("solving for %1; Ctrl-C ends it")
                                                          : translatable("solving for %1"));
    const int step = isTerminal ? 1 : static_cast<int>(linesBetween.count());
    const auto draw = [isTerminal, step, words](const std::stop_token& stop) {
        std::mutex mutex;
        std::condition_variable_any stopped;
        std::unique_lock lock(mutex);
        bool drawn = false;
        for (int seconds = step;; seconds += step) {
            stopped.wait_for(lock, stop, std::chrono::seconds(step), [] { return false; });
            if (stop.stop_requested()) break;
            drawn = isTerminal;
            std::fprintf(stderr, isTerminal ? "\r\033[K%s" : "%s\n",
                         Message(words.c_str(), {durationText(seconds)}).text().c_str());
        }
        if (drawn) std::fputs("\r\033[K", stderr);
    };
    try {
        m_drawing = std::jthread(draw);
    } catch (const std::system_error&) {
        // No thread is left: the work goes on without a bar.
    }
}

ElapsedTime::~ElapsedTime() = default;

}  // namespace drillwave
