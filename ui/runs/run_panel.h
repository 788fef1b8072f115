// SPDX-License-Identifier: GPL-3.0-or-later
// List of runs below the result: the present result first, then the pinned runs.
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

/// One result of each run and its difference from the reference. A box chooses the result. A tick draws a run
/// over the plots, F2 renames it, the menu has the rest.
class RunPanel : public QWidget {
    Q_OBJECT

  public:
    /// The runs must outlive it.
    explicit RunPanel(Runs& runs, QWidget* parent = nullptr);

    /// The present result.
    void present(const SolvedBlowPtr& blow);
    /// Whether the runs are there when the file is opened again: says so where they are not.
    void setKept(bool kept);
    QTreeWidget* list() const { return m_list; }

  signals:
    /// The user wants the scenario of that run back.
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
    QList<QAction*> m_ofRuns;  // what can be done with a run
    QAction* m_compareWithNow = nullptr;
    bool m_kept = false;
    bool m_filling = false;  // the list follows the runs, not the user
};

}  // namespace drillwave
