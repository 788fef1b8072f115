// SPDX-License-Identifier: GPL-3.0-or-later
// Interface of all pages of the window, and the answer with which a page begins.
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

/// A page asks for what it shows while it can be seen, and computes nothing otherwise.
class Page : public QWidget {
    Q_OBJECT

  public:
    using QWidget::QWidget;

    /// Name on the tab.
    virtual QString title() const = 0;
    /// Whether it has something to show for a scenario. Other pages cannot be chosen, have no tab if their
    /// answer is elsewhere(), and get no requests.
    virtual bool shows(const Scenario& /*scenario*/) const { return true; }
    /// Why it does not show a scenario and where the answer is, in one line. Empty if the user can make a
    /// scenario that it shows by its tab.
    virtual QString elsewhere() const { return {}; }
    /// Whether elsewhereRequested() leads there.
    virtual bool leadsElsewhere() const { return false; }
    /// Returns the function that makes the present data of this page from a blow; called only while the page
    /// can be seen. Empty if the page needs only the blow.
    virtual PreparePage prepare() const = 0;
    /// Shows an answer to a request for it, or for other pages.
    virtual void setResult(const SolvedBlowPtr& blow) = 0;
    /// Whether it can show one of many blows instead of a single one.
    virtual bool showsMarched() const { return false; }
    /// Brings everything into view.
    virtual void fit() = 0;
    /// Returns the exports of the page, in the order of a menu.
    virtual QList<PageExport> exports() const = 0;
    /// Returns the study that it runs in addition to the blow, for the status line; nullptr if it runs none.
    virtual StudyActivity* activity() const { return nullptr; }
    /// Adds what it has computed for the present scenario to a report, also while it cannot be seen.
    virtual void addTo(ReportStudies& /*studies*/) const {}
    /// Whether what it shows answers the present input: what does not is not copied.
    virtual void setCurrent(bool current) = 0;
    /// Shows a blow faintly while a value is dragged, for comparison; nullptr when the drag has ended.
    virtual void setGhost(const SolvedBlowPtr& /*before*/) {}
    /// The pinned runs, at first and whenever something of them has changed, also while the page cannot be
    /// seen.
    virtual void setRuns(const RunListPtr& /*runs*/) {}

  signals:
    /// The page needs something else now than in the last request.
    void needsChanged();
    /// title() is another one.
    void titleChanged();
    /// The user pins what the page shows of another scenario than the present one.
    void pinRequested(const drillwave::ScenarioDocument& contents);
    /// A value, or another scenario, has been taken from what the page shows, as the last undo step: "Feed
    /// force set to 9 kN".
    void valuesTaken(const QString& what);
    /// The user wants to go to where the answer is.
    void elsewhereRequested();
    /// The user wants one of the exports.
    void exportRequested(const drillwave::PageExport& wanted);

  protected:
    /// Makes the answer in bold with the button that copies it, once.
    QLayout* makeAnswer();
    QLabel* answerLabel() const { return m_answerLabel; }
    /// Returns the answer as text, for the clipboard.
    virtual QString answerText() const;
    QPushButton* newButton(const QString& name, const QString& text, const QString& tip);

  private:
    QLabel* m_answerLabel = nullptr;
};

}  // namespace drillwave
