// Solving away from the window's thread: one at a time, and the last request always gets its answer.
#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <QThreadPool>
#include <functional>
#include <optional>

#include "ui/solved_blow.h"

namespace drillwave {

/// Turns requests into answers on a worker thread. While one is in flight only the newest of the requests
/// that arrive is kept. Answers arrive in the order of their requests.
class SolveJob : public QObject {
    Q_OBJECT

  public:
    /// Called on a worker thread, never twice at the same time; what it throws becomes the answer's problem.
    using Solve = std::function<SolvedBlowPtr(const SolveRequest&)>;

    /// Solves exactly.
    explicit SolveJob(QObject* parent = nullptr);
    explicit SolveJob(Solve solve, QObject* parent = nullptr);
    /// Waits for the request in flight; its answer is dropped.
    ~SolveJob() override;

    void submit(const SolveRequest& request);
    /// Answers on the spot, after whatever is in flight: for the first picture of a window.
    SolvedBlowPtr solveNow(const SolveRequest& request);
    /// Forgets what is waiting, and the answer of what is in flight.
    void cancel();
    bool isBusy() const { return m_busy; }

  signals:
    void solved(const drillwave::SolvedBlowPtr& blow);

  private:
    void start(const SolveRequest& request);
    void finish();

    Solve m_solve;
    QThreadPool m_pool;
    QFutureWatcher<SolvedBlowPtr> m_watcher;
    std::optional<SolveRequest> m_waiting;
    bool m_busy = false;
};

}  // namespace drillwave
