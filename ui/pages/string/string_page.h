// SPDX-License-Identifier: GPL-3.0-or-later
// The page String: hammer and drill string drawn to scale with the stresses of the blow, and as an editable
// table.
#pragma once

#include "core/model/section_field.h"
#include "ui/document/document.h"
#include "ui/pages/page.h"

class QLabel;
class QTableView;
class QToolButton;

namespace drillwave {

class StringDrawing;
class StringEdits;
class StringModel;

class StringPage : public Page {
    Q_OBJECT

  public:
    /// Creates the page. The document must outlive it.
    explicit StringPage(Document& document, QWidget* parent = nullptr);

    QString title() const override { return tr("String"); }
    bool shows(const Scenario& scenario) const override { return sectionCount(scenario.drillString) > 0; }
    /// Returns no function, because this page needs no data besides the blow.
    PreparePage prepare() const override { return {}; }
    void setResult(const SolvedBlowPtr& blow) override;
    void fit() override {}
    QList<PageExport> exports() const override;
    void setCurrent(bool /*current*/) override {}

    /// Selects the table cell that shows a number of a section. If the address names several sections,
    /// selects the cell of the first one.
    void goTo(const SectionAddress& address);

    StringDrawing* drawing() const { return m_drawing; }
    StringModel* model() const { return m_model; }
    QTableView* table() const { return m_table; }
    StringEdits* edits() const { return m_edits; }

  signals:
    /// Reports that the user wants to know which value of this parameter gives a chosen result.
    void goalRequested(const QString& key);

  protected:
    QString answerText() const override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    QWidget* makeBar();
    void offerGoal();
    void fillTable();
    void followSelection();
    void showColumns();
    void fitLetters();
    void say(const QString& refusal);
    QString contents() const;
    QString largestStresses() const;
    void showAnswer();
    QByteArray csv() const;

    Document& m_document;
    StringModel* m_model;
    StringDrawing* m_drawing;
    QTableView* m_table;
    QToolButton* m_allColumns = nullptr;  // also shows columns that no section uses
    StringEdits* m_edits;
    QLabel* m_words;
    QString m_refusal;
};

}  // namespace drillwave
