// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/job/solve_job.h"

#include <utility>

namespace drillwave {
namespace {

// An exception that leaves a thread ends the program, so none does.
SolvedBlowPtr answered(const SolveJob::Solve& solve, const SolveRequest& request) {
    try {
        if (SolvedBlowPtr blow = solve(request)) return blow;
        return failedBlow(request, QStringLiteral("The solver gave no answer."));
    } catch (const std::exception& error) {
        return failedBlow(request, QString::fromUtf8(error.what()));
    } catch (...) {
        return failedBlow(request, QStringLiteral("The solver failed for an unknown reason."));
    }
}

SolveJob::Solve exactly() {
    // One solver keeps its workspace from blow to blow: the job never runs two at a time.
    auto solver = std::make_shared<MethodSolver>();
    return [solver](const SolveRequest& request) { return solveBlow(request, *solver); };
}

}  // namespace

SolveJob::SolveJob(QObject* parent) : SolveJob(exactly(), parent) {}

// The standard library's locks and not Qt's: the thread sanitizer sees what they protect.
SolveJob::SolveJob(Solve solve, QObject* parent)
    : QObject(parent), m_solve(std::move(solve)), m_thread([this] { work(); }) {
    m_patience.setSingleShot(true);
    m_patience.setInterval(patience);
    connect(&m_patience, &QTimer::timeout, this, [this] {
        if (m_waiting) m_stop.request_stop();
    });
}

SolveJob::~SolveJob() {
    m_stop.request_stop();
    {
        const std::lock_guard hold(m_lock);
        m_ending = true;
    }
    m_changed.notify_all();
    m_thread.join();
}

void SolveJob::submit(const SolveRequest& request) {
    if (!m_busy) return start(request);
    m_waiting = request;
    if (!m_patience.isActive()) m_stop.request_stop();
}

SolvedBlowPtr SolveJob::solveNow(const SolveRequest& request) {
    cancel();
    {
        std::unique_lock hold(m_lock);
        m_changed.wait(hold, [this] { return !m_request; });
    }
    return answered(m_solve, request);
}

void SolveJob::cancel() {
    m_waiting.reset();
    m_dropped = m_busy;
    m_stop.request_stop();
}

void SolveJob::start(const SolveRequest& request) {
    m_busy = true;
    m_dropped = false;
    m_stop = std::stop_source();
    m_patience.start();
    {
        const std::lock_guard hold(m_lock);
        m_request = request;
        m_request->stop = m_stop.get_token();
    }
    m_changed.notify_all();
}

void SolveJob::finish() {
    SolvedBlowPtr blow;
    {
        const std::lock_guard hold(m_lock);
        blow = std::move(m_answer);
    }
    m_busy = false;
    const bool cutShort = m_stop.stop_requested() && !blow->problem.isEmpty();
    const bool wanted = !m_dropped && !cutShort;
    if (m_waiting) start(*std::exchange(m_waiting, std::nullopt));
    if (wanted) emit solved(blow);
}

// On the worker thread. A request that has come stays where it is while it is solved: nobody replaces it
// before finish().
void SolveJob::work() {
    std::unique_lock hold(m_lock);
    while (true) {
        m_changed.wait(hold, [this] { return m_request || m_ending; });
        if (m_ending) return;
        hold.unlock();
        SolvedBlowPtr blow = answered(m_solve, *m_request);
        hold.lock();
        m_answer = std::move(blow);
        m_request.reset();
        m_changed.notify_all();
        QMetaObject::invokeMethod(this, &SolveJob::finish, Qt::QueuedConnection);
    }
}

}  // namespace drillwave
