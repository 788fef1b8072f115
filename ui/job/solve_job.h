// SPDX-License-Identifier: GPL-3.0-or-later
// Solving away from the window's thread: one at a time, and the last request always gets its answer.
#pragma once

#include <functional>

#include "ui/job/solved_blow.h"
#include "ui/job/worker.h"

namespace drillwave {

/// Turns requests into answers on a thread of its own: long work elsewhere must not delay a blow. Requests
/// replace each other as the tasks of a Worker do. Answers arrive in the order of their requests. A quick
/// answer is followed by the sure one, unless there is another request meanwhile.
class SolveJob : public QObject {
    Q_OBJECT

  public:
    /// Never called twice at the same time; the text of an exception becomes the answer's `fault`. It may
    /// ignore the request's `stop`, or end early on it with a fault, which nobody sees.
    using Solve = std::function<SolvedBlowPtr(const SolveRequest&)>;

    /// Solves exactly.
    explicit SolveJob(QObject* parent = nullptr);
    /// Stops the request in flight and waits for its end when it goes.
    explicit SolveJob(Solve solve, QObject* parent = nullptr);

    void submit(const SolveRequest& request);
    /// Answers on the spot, after whatever is in flight: for the first picture of a window.
    SolvedBlowPtr solveNow(const SolveRequest& request);
    /// Forgets what is waiting, and stops what is in flight.
    void cancel();
    bool isBusy() const { return m_worker.isBusy(); }

  signals:
    void solved(const drillwave::SolvedBlowPtr& blow);

  private:
    void start(const SolveRequest& request);

    Solve m_solve;
    std::uint64_t m_started = 0;  ///< counts start(): detects requests made meanwhile
    bool m_refining = false;      ///< the sure answer follows a quick one
    Worker m_worker;              // goes first: its thread solves
};

}  // namespace drillwave
