// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_solver.h"

#include <algorithm>

namespace drillwave {

RunSolver::RunSolver(Runs& runs, QObject* parent) : QObject(parent), m_runs(runs) {
    connect(&runs, &Runs::changed, this, &RunSolver::solveNext);
    connect(&m_job, &SolveJob::solved, this, [this](const SolvedBlowPtr& blow) {
        m_runs.setBlow(std::exchange(m_number, -1), blow);
        solveNext();
    });
}

void RunSolver::solveNext() {
    if (m_number >= 0) {
        if (m_runs.find(m_number)) return;  // it is on its way
        m_job.cancel();
        m_number = -1;
    }
    const auto next = std::ranges::find(*m_runs.list(), nullptr, &Run::blow);
    if (next == m_runs.list()->end()) return;
    m_number = next->number;
    const Scenario& scenario = next->contents.scenario;
    m_job.submit({.scenario = scenario, .units = naturalUnits(scenario), .chosenUnits = {}, .pages = {}});
}

}  // namespace drillwave
