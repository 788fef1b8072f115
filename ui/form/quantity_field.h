// SPDX-License-Identifier: GPL-3.0-or-later
// Input field for one physical quantity. It stores the exact SI value, accepts any unit, and shows the chosen
// unit.
#pragma once

#include <QAbstractSpinBox>
#include <QPointer>
#include <QString>
#include <QTimer>
#include <QToolButton>
#include <functional>
#include <optional>

#include "core/model/parameter.h"
#include "core/text/units.h"

class QAction;

namespace drillwave {

class UnitChoice;

// Flat button that shows a unit and opens the menu of other units.

class UnitButton : public QToolButton {
    Q_OBJECT

  public:
    explicit UnitButton(QWidget* parent = nullptr);

    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;
};

/// Input field whose SI value changes only by an edit, not by showing it in another unit or with fewer
/// digits. Invalid text remains and is marked with the reason, while the previous value is kept.
class QuantityField : public QAbstractSpinBox {
    Q_OBJECT

  public:
    /// Function that receives a value (SI) entered by the user. It returns why the value is refused; empty if
    /// accepted.
    using Taker = std::function<QString(double)>;

    QuantityField(Quantity quantity, const Unit& unit, QWidget* parent = nullptr);
    /// Makes a field for the values of a parameter; all fields of the parameter share one unit. `units` must
    /// outlive the field.
    QuantityField(const KeptParameter& parameter, const UnitChoice& units, QWidget* parent = nullptr);
    ~QuantityField() override;

    /// Returns the value in SI; nothing if an optional quantity is not given.
    std::optional<double> value() const { return m_value; }
    /// Sets the value (SI) from outside. Text being edited stays if it already means that value, or if it is
    /// wrong and the value did not change.
    void setValue(std::optional<double> si);
    /// Sets the function that receives each valid value: after every keystroke and every step.
    void setTaker(Taker taker) { m_taker = std::move(taker); }
    /// Permits an empty field, which then shows `placeholder`; emptying it emits cleared().
    void setOptional(const QString& placeholder);
    /// Sets the step size (SI) for a value of zero. For other values, a step is one unit of the second
    /// significant digit.
    void setStepAtZero(double si) { m_stepAtZero = si; }

    const Unit& unit() const { return *m_unit; }
    /// Sets the unit in which the value is shown; the value stays.
    void setUnit(const Unit& unit);
    /// Sets the tooltip, and the description for screen readers, that apply while the text is valid.
    void setHelp(const QString& tip, const QString& description);
    /// Returns the button that shows the unit and offers others (also by Alt+Down in the field); nullptr for
    /// quantities without units. The caller places it beside the field; it is deleted with the field.
    QToolButton* unitButton() const { return m_unitButton; }

    /// Returns why the text is refused; empty if it is accepted.
    QString problem() const { return m_problem; }
    /// Returns the nearest value (SI) that has three significant digits in the unit shown.
    double rounded(double si) const;

    void stepBy(int steps) override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

  signals:
    /// Emitted when the user empties an optional field.
    void cleared();
    /// Emitted when the reason shown for refused text changes; empty when the text is accepted.
    void problemShown(const QString& problem);
    /// Emitted when the user chooses the unit, from the menu or by typing it.
    void unitChosen(const drillwave::Unit& unit);
    /// Emitted when the field gets the focus.
    void entered();
    /// Emitted when a series of edits ends: on Enter, when the focus leaves, or a moment after the last step.
    void editsEnded();

  protected:
    StepEnabled stepEnabled() const override;
    bool event(QEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void readText(const QString& text);
    QString offer(double si);
    void empty();
    void refuse(const QString& reason);
    void accept();
    void showProblem();
    void showValue();
    void endEdits();
    QString shownText(double si) const;
    void createUnitButton(QWidget* parent);

    Quantity m_quantity;
    const Unit* m_unit;
    const Unit* m_typedUnit = nullptr;
    std::optional<double> m_value;
    // Value when editing began, which wrong text restores.
    std::optional<double> m_valueBefore;
    bool m_editing = false;
    double m_stepAtZero = 1;
    bool m_optional = false;
    Taker m_taker;
    QString m_problem;
    QString m_shownProblem;
    QString m_help;         // tooltip while the text is valid
    QString m_description;  // description for screen readers while the text is valid
    QTimer m_markTimer;
    QTimer m_stepTimer;
    QAction* m_mark = nullptr;
    QPointer<QToolButton> m_unitButton;
};

}  // namespace drillwave
