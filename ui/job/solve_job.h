// SPDX-License-Identifier: GPL-3.0-or-later
// Solves blows in another thread than the window's. The last request is always answered.
#pragma once

#include <functional>

#include "ui/job/solved_blow.h"
#include "ui/job/worker.h"

namespace drillwave {

/// Solver of blows with its own thread, so that long studies do not delay a blow. A new request replaces a
/// waiting one, see Worker. Answers arrive in the order of requests. An answer of reduced accuracy
/// (SolveRequest::quick) is followed by an accurate one, unless there is a new request.
class SolveJob : public QObject {
    Q_OBJECT

  public:
    /// Function that solves a request; never called twice at the same time. If it throws, the text of the
    /// exception becomes the `fault` of the answer. After a stop request (SolveRequest::stop) it may end
    /// early with a fault, which is not shown.
    using Solve = std::function<SolvedBlowPtr(const SolveRequest&)>;

    /// Makes a job that solves blows exactly, without a function of the caller.
    explicit SolveJob(QObject* parent = nullptr);
    /// Makes a job that calls `solve` for each request. The destructor stops the request in progress and
    /// waits for its end.
    explicit SolveJob(Solve solve, QObject* parent = nullptr);

    void submit(const SolveRequest& request);
    /// Solves a request in the caller's thread and returns the answer, so that a new window shows a result at
    /// once. Waits for the end of a request in progress.
    SolvedBlowPtr solveNow(const SolveRequest& request);
    /// Discards the waiting request and stops the one in progress.
    void cancel();
    bool isBusy() const { return m_worker.isBusy(); }

  signals:
    void solved(const drillwave::SolvedBlowPtr& blow);

  private:
    void start(const SolveRequest& request);

    Solve m_solve;
    std::uint64_t m_started = 0;  ///< number of requests started, to detect a newer request
    bool m_refining = false;      ///< the accurate answer after a quick one is in progress
    Worker m_worker;              // declared last: its thread must end first
};

}  // namespace drillwave
