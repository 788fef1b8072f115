// SPDX-License-Identifier: GPL-3.0-or-later
// The page Compare: the present result and the pinned runs side by side.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "ui/pages/compare/compare_model.h"
#include "ui/pages/page.h"
#include "ui/result/feed_text.h"
#include "ui/runs/runs.h"

class QComboBox;
class QLabel;
class QPushButton;
class QStackedLayout;
class QTableView;

namespace drillwave {

/// Page that shows the present result and the pinned runs (results kept for comparison) as columns of one
/// table.
class ComparePage : public Page {
    Q_OBJECT

  public:
    /// Creates the page. Runs and units must outlive it.
    ComparePage(Runs& runs, const UnitChoice& units, QWidget* parent = nullptr);

    QString title() const override;
    /// Returns no function, because this page needs no data besides the blow, whatever the kind of its
    /// scenario.
    PreparePage prepare() const override { return {}; }
    void setResult(const SolvedBlowPtr& blow) override;
    void fit() override;
    QList<PageExport> exports() const override;
    void setCurrent(bool current) override { m_current = current; }
    const CompareTable& table() const { return m_model->table(); }

  public slots:
    /// Copies the whole table to the clipboard, for a spreadsheet.
    void copy() const;

  signals:
    /// Reports that the user wants to return to the scenario of the pinned run with this number.
    void revertRequested(int number);

  protected:
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    QWidget* makeBar();
    void makeTable();
    void follow();
    void present();
    std::optional<FeedEstimate> ofAllGaps(int column, const SolvedBlow& blow);
    void forgetNeeds();
    void offerReferences();
    const Run* chosen() const;
    void choose();
    void chooseAgain();
    void fitHeader();
    QString obstacle() const;

    Runs& m_runs;
    const UnitChoice& m_units;
    SolvedBlowPtr m_now;
    bool m_current = true;
    QStackedLayout* m_layers;
    QLabel* m_empty;
    QComboBox* m_reference = nullptr;
    QPushButton* m_revert = nullptr;
    QTableView* m_view;
    std::map<int, std::unique_ptr<WorstNeed>> m_needs;  // by number of the run; see presentResult
    // Number of the run whose column is chosen; empty for the present result.
    std::optional<int> m_chosen;
    CompareModel* m_model;
};

}  // namespace drillwave
