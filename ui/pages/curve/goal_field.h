// SPDX-License-Identifier: GPL-3.0-or-later
// Field for the target value of a result.
#pragma once

#include <QLineEdit>
#include <optional>

#include "core/text/units.h"

namespace drillwave {

/// Field for the value that a result should reach, such as "0.7" or "240 kN", in the number format of the
/// user. It is empty without a goal. Invalid text stays, is marked with its reason, and changes nothing.
class GoalField : public QLineEdit {
    Q_OBJECT

  public:
    explicit GoalField(QWidget* parent = nullptr);

    /// Returns the goal in SI, or as a plain number for a dimensionless result; nothing without a goal.
    std::optional<double> value() const { return m_value; }
    /// Shows a goal (in SI) converted to `unit`; no value empties the field. Numbers typed without a unit are
    /// read in `unit`. Emits no signal. Text being typed stays if value, quantity and unit are the same as
    /// before.
    void present(std::optional<double> value, Quantity quantity, const Unit& unit);
    /// Returns why the text is not a valid goal; empty if it is valid.
    const QString& problem() const { return m_problem; }
    /// Returns the goal as an argument of the command line, such as "240 kN". Requires that value() is not
    /// empty.
    std::string commandText() const;

  signals:
    /// Reports that value() has changed.
    void changed();

  private:
    void read();
    void presentProblem();

    std::optional<double> m_value;
    Quantity m_quantity = Quantity::ratio;
    const Unit* m_unit;
    QString m_problem;
};

}  // namespace drillwave
