// SPDX-License-Identifier: GPL-3.0-or-later
// Solves runs that have no blow yet: those of a file, and points of a study that were pinned.
#pragma once

#include "ui/job/solve_job.h"
#include "ui/runs/runs.h"

namespace drillwave {

/// One after the other, on a thread of its own.
class RunSolver : public QObject {
    Q_OBJECT

  public:
    /// The runs must outlive it.
    explicit RunSolver(Runs& runs, QObject* parent = nullptr);

    bool isBusy() const { return m_job.isBusy(); }

  private:
    void solveNext();

    Runs& m_runs;
    int m_number = -1;  // of the run that is being solved
    SolveJob m_job;     // goes first: its thread solves
};

}  // namespace drillwave
