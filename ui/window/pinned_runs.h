// SPDX-License-Identifier: GPL-3.0-or-later
// Pinned runs in the window: pins, solves, lists, compares, reverts and keeps them.
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
    /// Document, questions and window must outlive it.
    PinnedRuns(Document& document, Questions& questions, QWidget* window);

    Runs& runs() { return m_runs; }
    /// The list, for the window to place and to keep.
    RunPanel* panel() const { return m_panel; }
    /// Asks to pin the present result; see pin().
    QAction* pinAction() const { return m_pinAction; }
    /// Keeps the runs beside the scenario file, or stops that.
    QAction* keepAction() const { return m_keepAction; }
    /// Has the numbers of the panel compared with the reference.
    void follow(ResultPanel& result);
    /// Adds the page that compares them, and has all pages know them. Once.
    void addTo(PageTabs& pages);

    /// The present result, which may be of an earlier scenario. Pins that wait for it get it.
    void present(const SolvedBlowPtr& blow);
    /// Pins the present scenario with its result; if that is not there yet, the run waits for it, whatever is
    /// changed or shown meanwhile.
    void pin();
    /// Brings back the scenario of a run, as one undo step.
    void revertTo(int number);
    /// Asks the open questions, and waits until the runs are written. False if that has failed and the user
    /// wants to keep the window.
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
    QString m_othersFolder;  // of the question about it; empty without
};

}  // namespace drillwave
