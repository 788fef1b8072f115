// SPDX-License-Identifier: GPL-3.0-or-later
// The law of bit and rock in the form: which it is, and the corners of its loading curve.
#pragma once

#include <QGridLayout>
#include <QObject>
#include <QVBoxLayout>
#include <vector>

#include "ui/document/document.h"

class QToolButton;

namespace drillwave {

class ChoiceBox;
class QuantityField;

/// Its widgets live in the grid of the section of bit and rock. Rows of the table of parameters show all
/// values of a law except its corners.
class LawSection : public QObject {
    Q_OBJECT

  public:
    /// Fills the next rows of `grid`. The document must outlive it.
    LawSection(Document& document, QGridLayout* grid, QWidget* parent);
    void present(const Scenario& scenario);

  private:
    struct Row {
        QWidget* box;
        QuantityField* force;
        QuantityField* slope;
    };

    void choose(RockLaw law);
    void change(const BitRock& rock, const QString& step);
    void setCornerCount(std::size_t count);
    QuantityField* addField(std::size_t corner, const char* part, const QString& words, QWidget* row);
    void addCorner();
    void removeCorner(std::size_t corner);

    Document& m_document;
    ChoiceBox* m_law;
    QWidget* m_corners;
    QVBoxLayout* m_lines;
    QToolButton* m_add;
    std::vector<Row> m_rows;
    ScenarioForm m_form = ScenarioForm::dimensional;  // whose units the rows have
    int m_gesture;
};

}  // namespace drillwave
