// SPDX-License-Identifier: GPL-3.0-or-later
// One parameter in the form: name, slider, field, unit, and a line for an error.
#pragma once

#include <QGridLayout>
#include <QLabel>
#include <QToolButton>

#include "core/model/parameter.h"
#include "ui/form/problem_plate.h"
#include "ui/form/quantity_field.h"
#include "ui/form/quantity_slider.h"

namespace drillwave {

/// Columns of the grid of a section: name, slider, field, unit.
inline constexpr int formColumns = 4;

/// Made only from an entry of the parameter table. Its widgets live in the grid of the section.
class ParameterRow : public QObject {
    Q_OBJECT

  public:
    /// Fills the two lowest rows of `grid`; `sectionTitle` goes into the accessible names. The units must
    /// outlive it.
    ParameterRow(const Parameter& parameter, UnitChoice& units, const QString& sectionTitle,
                 QGridLayout* grid, QWidget* parent);

    const Parameter& parameter() const { return m_parameter; }
    QuantityField* field() const { return m_field; }
    QuantitySlider* slider() const { return m_slider; }

    /// Widths that the columns of labels and units need [px].
    int labelWidth() const { return m_label->sizeHint().width(); }
    int unitWidth() const { return m_field->unitButton() ? m_field->unitButton()->sizeHint().width() : 0; }

    /// Shows the parameter's value in the scenario, or hides the row where it does not apply.
    void present(const Scenario& scenario);

    /// Sets the receiver of values given by the user, in the field or by the slider.
    void setTaker(QuantityField::Taker taker);

  signals:
    void cleared();
    /// The user wants the value of the parameter for a given result.
    void goalRequested();
    /// The slider was clicked twice: back to the value of the file.
    void resetRequested();
    /// Further edits are a new undo step.
    void editsEnded();

  private:
    void setVisible(bool visible);
    void nameWidgets(const QString& sectionTitle);
    void offerGoal();
    void tell();
    void drag(double si);
    void showProblem(const QString& problem);
    bool isElsewhere() const;

    const Parameter& m_parameter;
    QLabel* m_label;
    QuantityField* m_field;
    QuantitySlider* m_slider;
    ProblemPlate* m_plate;
    QuantityField::Taker m_taker;
};

}  // namespace drillwave
