// SPDX-License-Identifier: GPL-3.0-or-later
// Form rows for the bit-rock law: the kind of law, and the corners of its loading curve.
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

/// Rows of the input form for the choice of the bit-rock law and for the corners of its loading curve. Other
/// values of the law, such as its stiffness, have a ParameterRow each.
class LawSection : public QObject {
    Q_OBJECT

  public:
    /// Adds the rows at the end of `grid`. The document must outlive this object.
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
    ScenarioForm m_form = ScenarioForm::dimensional;  // form of the scenario shown, which sets the units
    int m_gesture;
};

}  // namespace drillwave
