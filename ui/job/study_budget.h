// SPDX-License-Identifier: GPL-3.0-or-later
// Seconds that a study may take unasked.
#pragma once

#include <chrono>
#include <optional>
#include <stop_token>

namespace drillwave {

/// Stops work that takes longer than its seconds, once there is something to show. Threads of the work may
/// share it.
class StudyBudget {
  public:
    /// No limit without seconds. A stop of `from` is a stop of the work.
    StudyBudget(std::optional<double> seconds, const std::stop_token& from)
        : m_seconds(seconds), m_chain(from, Chain{&m_stop}) {}

    /// The token that the work looks at.
    std::stop_token token() const { return m_stop.get_token(); }
    double elapsed() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_begin).count();
    }
    bool isSpent() const { return m_seconds && elapsed() >= *m_seconds; }
    /// Whether work of so many seconds more still fits.
    bool hasRoomFor(double seconds) const { return !m_seconds || elapsed() + seconds <= *m_seconds; }
    /// Stops the work where the seconds are over.
    void check() {
        if (isSpent()) m_stop.request_stop();
    }

  private:
    struct Chain {
        std::stop_source* stop;
        void operator()() const { stop->request_stop(); }
    };

    std::optional<double> m_seconds;
    std::chrono::steady_clock::time_point m_begin = std::chrono::steady_clock::now();
    std::stop_source m_stop;
    std::stop_callback<Chain> m_chain;
};

}  // namespace drillwave
