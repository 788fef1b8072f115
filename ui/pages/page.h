// SPDX-License-Identifier: GPL-3.0-or-later
// Interface of all pages of the window.
#pragma once

#include <QWidget>

#include "ui/job/solved_blow.h"
#include "ui/pages/page_export.h"
#include "ui/runs/runs.h"

class QLabel;
class QLayout;
class QPushButton;

namespace drillwave {

struct ReportStudies;
class StudyActivity;

/// Page of the window. It requests its data only while it is visible, and computes nothing otherwise.
class Page : public QWidget {
    Q_OBJECT

  public:
    using QWidget::QWidget;

    /// Returns the title of the page's tab.
    virtual QString title() const = 0;
    /// Returns whether the page has something to show for a scenario. If not, it cannot be chosen and gets no
    /// requests; it has no tab if elsewhere() is not empty.
    virtual bool shows(const Scenario& /*scenario*/) const { return true; }
    /// Returns why the page does not show the present scenario and where the answer is, in one line. Empty if
    /// its tab lets the user create a scenario that it can show.
    virtual QString elsewhere() const { return {}; }
    /// Returns whether the window can open the place that elsewhere() names. If so, the user can ask for it,
    /// which emits elsewhereRequested().
    virtual bool leadsElsewhere() const { return false; }
    /// Returns the function that computes the data of this page from a blow; called only while the page is
    /// visible. Empty if the page needs only the blow.
    virtual PreparePage prepare() const = 0;
    /// Shows a solved blow that was requested by this page or by others.
    virtual void setResult(const SolvedBlowPtr& blow) = 0;
    /// Returns whether the page can show one blow of a sequence as well as a single blow.
    virtual bool showsMarched() const { return false; }
    /// Sets axis ranges, or heights of table rows, so that everything on the page is visible.
    virtual void fit() = 0;
    /// Returns the exports of the page, in the order of the menu.
    virtual QList<PageExport> exports() const = 0;
    /// Returns the study that the page runs in addition to the blow, for the status line; nullptr if it runs
    /// none.
    virtual StudyActivity* activity() const { return nullptr; }
    /// Adds the results of the page for the present scenario to a report, even if the page is hidden.
    virtual void addTo(ReportStudies& /*studies*/) const {}
    /// Sets whether the page shows results of the present input. Outdated results cannot be copied.
    virtual void setCurrent(bool current) = 0;
    /// Shows the blow before a drag faintly while the user drags a value; nullptr when the drag has ended.
    virtual void setGhost(const SolvedBlowPtr& /*before*/) {}
    /// Sets the pinned runs (results kept for comparison). Called once at first and after every change, even
    /// if the page is hidden.
    virtual void setRuns(const RunListPtr& /*runs*/) {}

  signals:
    /// Reports that the page needs other data than it last requested.
    void needsChanged();
    /// Reports that title() has changed.
    void titleChanged();
    /// Reports that the user wants to pin a run for another scenario, which the page shows.
    void pinRequested(const drillwave::ScenarioDocument& contents);
    /// Reports that values of the page were taken into the scenario as one undo step. `what` says which, such
    /// as "Feed force set to 9 kN".
    void valuesTaken(const QString& what);
    /// Reports that the user wants to go to the place that shows the answer; see elsewhere().
    void elsewhereRequested();
    /// Reports that the user wants to save one of the exports.
    void exportRequested(const drillwave::PageExport& wanted);

  protected:
    /// Creates the label for the page's answer (its main result in one sentence), in bold, and the button
    /// that copies the answer. Returns their layout. Call it once.
    QLayout* makeAnswer();
    QLabel* answerLabel() const { return m_answerLabel; }
    /// Returns the page's answer (its main result in one sentence) as text for the clipboard.
    virtual QString answerText() const;
    QPushButton* newButton(const QString& name, const QString& text, const QString& tip);

  private:
    QLabel* m_answerLabel = nullptr;
};

}  // namespace drillwave
