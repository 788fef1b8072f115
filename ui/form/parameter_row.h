// SPDX-License-Identifier: GPL-3.0-or-later
// Form row of one parameter: name, slider, field, unit, and a line for an error.
#pragma once

#include <QGridLayout>
#include <QLabel>
#include <QToolButton>

#include "core/model/parameter.h"
#include "ui/form/problem_plate.h"
#include "ui/form/quantity_field.h"
#include "ui/form/quantity_slider.h"

namespace drillwave {

/// Number of columns in the grid of a section: name, slider, field, unit.
inline constexpr int formColumns = 4;

/// Form row of one parameter: name, slider, field and unit. Its widgets are in the grid of the section.
class ParameterRow : public QObject {
    Q_OBJECT

  public:
    /// Adds a row at the end of `grid`. `sectionTitle` becomes part of the names that screen readers speak.
    /// `units` must outlive this object.
    ParameterRow(const Parameter& parameter, UnitChoice& units, const QString& sectionTitle,
                 QGridLayout* grid, QWidget* parent);

    const Parameter& parameter() const { return m_parameter; }
    QuantityField* field() const { return m_field; }
    QuantitySlider* slider() const { return m_slider; }

    /// Returns the width that the column of names needs [px].
    int labelWidth() const { return m_label->sizeHint().width(); }
    /// Returns the width that the column of units needs [px].
    int unitWidth() const { return m_field->unitButton() ? m_field->unitButton()->sizeHint().width() : 0; }

    /// Shows the parameter's value in the scenario; hides the row if the scenario does not have the
    /// parameter.
    void present(const Scenario& scenario);

    /// Sets the function that receives values entered in the field or set by the slider.
    void setTaker(QuantityField::Taker taker);

  signals:
    void cleared();
    /// Emitted when the user asks which value of the parameter gives a wanted result.
    void goalRequested();
    /// Emitted when the slider was double-clicked, to restore the value of the file.
    void resetRequested();
    /// Emitted when a series of edits ends: later edits are a new undo step.
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
