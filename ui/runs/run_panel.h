// SPDX-License-Identifier: GPL-3.0-or-later
// The list of runs below the result: the present result first, then the pinned runs (results kept for
// comparison).
#pragma once

#include <QWidget>

#include "ui/runs/runs.h"

class QAction;
class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace drillwave {

class ChoiceBox;
struct Output;

/// List of the present result and the pinned runs, with one result value of each and its difference from the
/// reference. A list box chooses the value. A tick mark shows a run in the plots, F2 renames it, and the
/// context menu has further actions.
class RunPanel : public QWidget {
    Q_OBJECT

  public:
    /// Creates the list. The runs must outlive it.
    explicit RunPanel(Runs& runs, QWidget* parent = nullptr);

    /// Shows the results of the present blow in the first row of the list, above the pinned runs.
    void present(const SolvedBlowPtr& blow);
    /// Sets whether the pinned runs are stored in files and reopened with the scenario file. If not, a hint
    /// above the list says so.
    void setKept(bool kept);
    QTreeWidget* list() const { return m_list; }

  signals:
    /// Reports that the user wants to restore the scenario of the run with this number.
    void revertRequested(int number);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    enum Column { name, value, change, columns };

    ChoiceBox* makeChoice();
    const Output& output() const;
    void addActions();
    QAction* add(const QString& text, const QKeySequence& keys, const std::function<void(const Run&)>& then);
    void fill();
    void fillRow(QTreeWidgetItem& row, const SolvedBlowPtr& blow, const Run* reference) const;
    void take(QTreeWidgetItem* row, int column);
    const Run* chosen() const;
    void update();

    Runs& m_runs;
    SolvedBlowPtr m_now;
    QLabel* m_hint;
    ChoiceBox* m_output;
    QTreeWidget* m_list;
    QList<QAction*> m_ofRuns;  // actions for a run
    QAction* m_compareWithNow = nullptr;
    bool m_kept = false;
    bool m_filling = false;  // whether the list changes because of the runs, not the user
};

}  // namespace drillwave
