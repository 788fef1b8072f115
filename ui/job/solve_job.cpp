// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/job/solve_job.h"

#include <utility>

#include "ui/job/solved_blow.h"

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
    // The solver keeps its workspace from blow to blow: the job never runs two at a time.
    struct Kept {
        // Nobody can permit more work in the window.
        MethodSolver solver{WorkLimits{.pieces = mostWorkLimit}};
        std::weak_ptr<const SolvedBlow> last;  // as long as somebody shows it
    };
    auto kept = std::make_shared<Kept>();
    return [kept](const SolveRequest& request) {
        const SolvedBlowPtr last = kept->last.lock();
        const SolvedBlowPtr blow = last && answersAgain(*last, request)
                                       ? answerAgain(*last, request)
                                       : solveBlow(request, kept->solver, last.get());
        kept->last = blow;
        return blow;
    };
}

}  // namespace

SolveJob::SolveJob(QObject* parent) : SolveJob(exactly(), parent) {}

SolveJob::SolveJob(Solve solve, QObject* parent) : QObject(parent), m_solve(std::move(solve)) {}

void SolveJob::submit(const SolveRequest& request) {
    if (m_refining) cancel();  // a better answer to the last question holds up no new one
    start(request);
}

void SolveJob::start(const SolveRequest& request) {
    m_worker.submit([this, request, number = ++m_started](const std::stop_token& stop) -> Worker::Delivery {
        SolveRequest stoppable = request;
        stoppable.stop = stop;
        const SolvedBlowPtr blow = answered(m_solve, stoppable);
        return [this, blow, stop, request, number] {
            const bool cutShort = stop.stop_requested() && !blow->fault.isEmpty();
            if (number == m_started) m_refining = false;
            if (!cutShort) emit solved(blow);
            if (!blow->request.quick || !blow->fault.isEmpty() || number != m_started) return;
            SolveRequest sure = request;
            sure.quick = false;
            start(sure);
            m_refining = true;
        };
    });
}

void SolveJob::cancel() {
    m_refining = false;
    m_worker.cancel();
}

SolvedBlowPtr SolveJob::solveNow(const SolveRequest& request) {
    m_worker.cancel();
    m_worker.waitForThread();
    return answered(m_solve, request);
}

}  // namespace drillwave
