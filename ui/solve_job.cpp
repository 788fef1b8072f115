#include "ui/solve_job.h"

#include <QPromise>
#include <QtConcurrent>
#include <utility>

namespace drillwave {
namespace {

// An exception that leaves a task loses its message on the way, so none does.
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
    auto solver = std::make_shared<ExactSolver>();
    return [solver](const SolveRequest& request) { return solveBlow(request, *solver); };
}

}  // namespace

SolveJob::SolveJob(QObject* parent) : SolveJob(exactly(), parent) {}

SolveJob::SolveJob(Solve solve, QObject* parent) : QObject(parent), m_solve(std::move(solve)) {
    // A thread of its own: long work elsewhere must not keep a blow waiting.
    m_pool.setMaxThreadCount(1);
    m_pool.setExpiryTimeout(-1);
    connect(&m_watcher, &QFutureWatcherBase::finished, this, &SolveJob::finish);
}

SolveJob::~SolveJob() {
    cancel();
    m_watcher.waitForFinished();
}

void SolveJob::submit(const SolveRequest& request) {
    if (m_busy)
        m_waiting = request;
    else
        start(request);
}

SolvedBlowPtr SolveJob::solveNow(const SolveRequest& request) {
    cancel();
    m_watcher.waitForFinished();
    return answered(m_solve, request);
}

void SolveJob::cancel() {
    m_waiting.reset();
    m_watcher.cancel();
}

void SolveJob::start(const SolveRequest& request) {
    m_busy = true;
    m_watcher.setFuture(
        QtConcurrent::run(&m_pool, [solve = m_solve, request](QPromise<SolvedBlowPtr>& promise) {
            if (!promise.isCanceled()) promise.addResult(answered(solve, request));
        }));
}

void SolveJob::finish() {
    m_busy = false;
    const bool dropped = m_watcher.isCanceled();
    const SolvedBlowPtr blow = dropped ? nullptr : m_watcher.result();
    if (m_waiting) start(*std::exchange(m_waiting, std::nullopt));
    if (blow) emit solved(blow);
}

}  // namespace drillwave
