// SPDX-License-Identifier: GPL-3.0-or-later
// A field for one physical quantity: holds the exact SI value, takes any unit, shows the unit of choice.
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

// A flat button that shows a unit and opens the menu of the others.

class UnitButton : public QToolButton {
    Q_OBJECT

  public:
    explicit UnitButton(QWidget* parent = nullptr);

    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;
};

/// Holds a double in SI that only an edit changes: showing it in another unit or with fewer digits does not.
/// Invalid text stays, marked with the reason, and the old value is kept.
class QuantityField : public QAbstractSpinBox {
    Q_OBJECT

  public:
    /// Takes a value (SI) that the user gave. Returns why it cannot be taken; empty when it was.
    using Taker = std::function<QString(double)>;

    QuantityField(Quantity quantity, const Unit& unit, QWidget* parent = nullptr);
    /// Makes a field for the values of a parameter. All fields of the parameter share one unit. The units
    /// must outlive it.
    QuantityField(const KeptParameter& parameter, const UnitChoice& units, QWidget* parent = nullptr);
    ~QuantityField() override;

    /// The value in SI; nothing where an optional quantity is not given.
    std::optional<double> value() const { return m_value; }
    /// Shows a value from elsewhere. Text being edited stays if it already means that value, or if it is
    /// wrong and the value did not change.
    void setValue(std::optional<double> si);
    /// Sets the receiver of every value: of each keystroke that makes one, and of each step.
    void setTaker(Taker taker) { m_taker = std::move(taker); }
    /// Lets the field be emptied (`cleared()`), and shows `placeholder` then.
    void setOptional(const QString& placeholder);
    /// Sets the size of a step (SI) for a value of zero, which has no size of its own.
    void setStepAtZero(double si) { m_stepAtZero = si; }

    const Unit& unit() const { return *m_unit; }
    /// Changes what is shown, not the value.
    void setUnit(const Unit& unit);
    /// Sets the tip and the text for screen readers while nothing is wrong.
    void setHelp(const QString& tip, const QString& description);
    /// Shows the unit and offers the others (also by Alt+Down in the field); nullptr for a ratio. The caller
    /// lays it out beside the field; it is deleted with the field.
    QToolButton* unitButton() const { return m_unitButton; }

    /// Why the text is not taken, empty when it is.
    QString problem() const { return m_problem; }
    /// The nearest value with three significant digits in the unit shown.
    double rounded(double si) const;

    void stepBy(int steps) override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

  signals:
    /// The user emptied an optional field.
    void cleared();
    /// The reason that is shown now changed; empty when there is none any more.
    void problemShown(const QString& problem);
    /// The user has chosen the unit that is shown, from the list or by typing it.
    void unitChosen(const drillwave::Unit& unit);
    /// The focus comes.
    void entered();
    /// A series of edits has come to its end: Enter, or the focus leaves.
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
    std::optional<double> m_valueBefore;  // what wrong text falls back to: the value when editing began
    bool m_editing = false;
    double m_stepAtZero = 1;
    bool m_optional = false;
    Taker m_taker;
    QString m_problem;
    QString m_shownProblem;
    QString m_help;         // the tip while nothing is wrong
    QString m_description;  // the text for screen readers then
    QTimer m_markTimer;
    QTimer m_stepTimer;
    QAction* m_mark = nullptr;
    QPointer<QToolButton> m_unitButton;
};

}  // namespace drillwave
