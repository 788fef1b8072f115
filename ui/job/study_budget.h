// SPDX-License-Identifier: GPL-3.0-or-later
// Time limit of a study that the user has not explicitly asked for.
#pragma once

#include <chrono>
#include <optional>
#include <stop_token>

namespace drillwave {

/// Time limit of a computation. The computation calls check() as soon as it has intermediate results to show;
/// check() stops it after the limit. Threads of the computation may share the object.
class StudyBudget {
  public:
    /// Starts the clock. `seconds` is the time limit [s]; nothing for no limit. A stop requested through
    /// `from` also stops the work.
    StudyBudget(std::optional<double> seconds, const std::stop_token& from)
        : m_seconds(seconds), m_chain(from, Chain{&m_stop}) {}

    /// Returns the stop token that the work must check.
    std::stop_token token() const { return m_stop.get_token(); }
    double elapsed() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_begin).count();
    }
    bool isSpent() const { return m_seconds && elapsed() >= *m_seconds; }
    /// Returns true if further work that takes `seconds` [s] fits into the time limit.
    bool hasRoomFor(double seconds) const { return !m_seconds || elapsed() + seconds <= *m_seconds; }
    /// Stops the work if the time limit has passed. Call it only when intermediate results can be shown.
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
