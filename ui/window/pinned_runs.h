// SPDX-License-Identifier: GPL-3.0-or-later
// Pinned runs: results that the user keeps, to compare later results with them.
#pragma once

#include <QObject>

#include "ui/document/document.h"
#include "ui/questions/questions.h"
#include "ui/runs/run_keeper.h"
#include "ui/runs/run_panel.h"
#include "ui/runs/runs.h"

class QAction;

namespace drillwave {

class PageTabs;
class ResultPanel;

class PinnedRuns : public QObject {
    Q_OBJECT

  public:
    /// Creates an empty list of pinned runs. `document`, `questions` (which asks the user in dialogs) and
    /// `window` must outlive this object.
    PinnedRuns(Document& document, Questions& questions, QWidget* window);

    Runs& runs() { return m_runs; }
    /// Returns the panel that lists the pinned runs; the window places it in its own layout.
    RunPanel* panel() const { return m_panel; }
    /// Returns the action that pins (keeps for comparison) the present result; see pin().
    QAction* pinAction() const { return m_pinAction; }
    /// Returns the action that stores the runs in a folder beside the scenario file, or stops that.
    QAction* keepAction() const { return m_keepAction; }
    /// Makes the result panel show how its numbers differ from those of the reference run (the pinned run
    /// chosen for comparison).
    void follow(ResultPanel& result);
    /// Adds the page Compare, on which pinned runs are compared, and passes the runs to all pages. Must be
    /// called once.
    void addTo(PageTabs& pages);

    /// Sets the blow whose results are displayed; it may belong to an earlier scenario. Pinned runs that have
    /// the same scenario but no result yet take it as their result.
    void present(const SolvedBlowPtr& blow);
    /// Pins the present scenario with its result. If the result is not computed yet, it is added to the run
    /// later, even if the scenario has changed by then.
    void pin();
    /// Restores the scenario of the run with this number, as one undo step.
    void revertTo(int number);
    /// Asks any pending question about stored runs, and waits until the pinned runs are stored. Returns false
    /// if storing failed and the user wants to keep the window open.
    bool mayClose();

  private:
    void pin(ScenarioDocument contents, const SolvedBlowPtr& blow);
    bool isResultCurrent() const;
    void keep(bool wanted);
    void askAboutOthers();
    void fail(const QString& what, const QString& problem);

    Document& m_document;
    Questions& m_questions;
    QWidget* m_window;
    Runs m_runs;
    RunSolver m_solver;
    RunKeeper m_keeper;
    QAction* m_pinAction;
    QAction* m_keepAction;
    RunPanel* m_panel;
    SolvedBlowPtr m_now;
    QString m_othersFolder;  // folder with runs of others, about which the user must be asked; empty for none
};

}  // namespace drillwave
