// SPDX-License-Identifier: GPL-3.0-or-later
// Solving away from the window's thread: one at a time, and the last request always gets its answer.
#pragma once

#include <QObject>
#include <QTimer>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include "ui/job/solved_blow.h"

namespace drillwave {

/// Turns requests into answers on a thread of its own: long work elsewhere must not keep a blow waiting.
/// While one is in flight only the newest of the requests that arrive is kept; one that has been in flight
/// for long is stopped when another is waiting. Answers arrive in the order of their requests.
class SolveJob : public QObject {
    Q_OBJECT

  public:
    /// Never called twice at the same time; what it throws becomes the answer's problem. It may ignore the
    /// request's `stop`, or end early on it with a problem, which nobody sees.
    using Solve = std::function<SolvedBlowPtr(const SolveRequest&)>;

    /// Solves exactly.
    explicit SolveJob(QObject* parent = nullptr);
    explicit SolveJob(Solve solve, QObject* parent = nullptr);
    /// Stops the request in flight and waits for its end.
    ~SolveJob() override;

    void submit(const SolveRequest& request);
    /// Answers on the spot, after whatever is in flight: for the first picture of a window.
    SolvedBlowPtr solveNow(const SolveRequest& request);
    /// Forgets what is waiting, and stops what is in flight.
    void cancel();
    bool isBusy() const { return m_busy; }

  signals:
    void solved(const drillwave::SolvedBlowPtr& blow);

  private:
    /// While values are dragged every answer that takes less is seen.
    static constexpr std::chrono::milliseconds patience{250};

    void start(const SolveRequest& request);
    void finish();
    void work();

    Solve m_solve;

    // Seen by the window's thread only.
    std::optional<SolveRequest> m_waiting;
    bool m_busy = false;      // from start() to finish(), which comes through the event loop
    bool m_dropped = false;   // nobody wants the answer in flight any more
    std::stop_source m_stop;  // of what is in flight
    QTimer m_patience;        // runs out when what is in flight may be stopped for what is waiting

    // What the two threads hand each other, under the lock.
    std::mutex m_lock;
    std::condition_variable m_changed;
    std::optional<SolveRequest> m_request;  // from start() until it is answered
    SolvedBlowPtr m_answer;
    bool m_ending = false;

    std::thread m_thread;
};

}  // namespace drillwave
