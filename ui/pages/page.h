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
    /// Returns whether the page has something to show for a scenario. If not, the user cannot open it and it
    /// gets no requests. Its tab then stays visible only if elsewhere() is empty.
    virtual bool shows(const Scenario& /*scenario*/) const { return true; }
    /// Returns one line for a page that cannot show the present scenario: the reason, and where the user
    /// finds the answer. Empty if a click on the page's tab converts the scenario into one that it can show.
    virtual QString elsewhere() const { return {}; }
    /// Returns whether the window can open the place that elsewhere() names. If so, a button for it is shown,
    /// which emits elsewhereRequested().
    virtual bool leadsElsewhere() const { return false; }
    /// Returns the function that computes the data of this page from a blow; called only while the page is
    /// visible. Empty if the page needs only the blow.
    virtual PreparePage prepare() const = 0;
    /// Shows a solved blow that was requested by this page or by others.
    virtual void setResult(const SolvedBlowPtr& blow) = 0;
    /// Returns whether the page can also show a blow taken from a sequence of blows, not only a blow from
    /// rest.
    virtual bool showsMarched() const { return false; }
    /// Sets axis ranges, or heights of table rows, so that everything on the page is visible.
    virtual void fit() = 0;
    /// Returns the exports of the page (data and pictures that the user can save), in the order of the menu.
    virtual QList<PageExport> exports() const = 0;
    /// Returns the study that the page runs besides the blow, whose progress the status line shows; nullptr
    /// if it runs none.
    virtual StudyActivity* activity() const { return nullptr; }
    /// Adds the results of the page for the present scenario to a report, even if the page is hidden.
    virtual void addTo(ReportStudies& /*studies*/) const {}
    /// Sets whether the results shown belong to the present input. Outdated results cannot be copied.
    virtual void setCurrent(bool current) = 0;
    /// Shows the blow before a drag faintly, for comparison, while the user drags a value; nullptr when the
    /// drag has ended.
    virtual void setGhost(const SolvedBlowPtr& /*before*/) {}
    /// Sets the pinned runs (results kept for comparison). Called once at first and after every change, even
    /// if the page is hidden.
    virtual void setRuns(const RunListPtr& /*runs*/) {}

  signals:
    /// Reports that the page needs other data of the blow than it requested last.
    void needsChanged();
    /// Reports that title() has changed.
    void titleChanged();
    /// Reports that the user wants to pin a run (a result kept for comparison) for the scenario `contents`,
    /// which is not the present one.
    void pinRequested(const drillwave::ScenarioDocument& contents);
    /// Reports that values of the page were taken into the scenario as one undo step. `what` says which, such
    /// as "Feed force set to 9 kN".
    void valuesTaken(const QString& what);
    /// Reports that the user wants to go to the place that elsewhere() names.
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
