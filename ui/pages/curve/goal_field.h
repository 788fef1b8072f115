// SPDX-License-Identifier: GPL-3.0-or-later
// Field for the target value of a result.
#pragma once

#include <QLineEdit>
#include <optional>

#include "core/text/units.h"

namespace drillwave {

/// "0.7" or "240 kN" in the numbers of the user; none where it is empty. Text that is neither stays, marked
/// with the reason, and changes nothing.
class GoalField : public QLineEdit {
    Q_OBJECT

  public:
    explicit GoalField(QWidget* parent = nullptr);

    /// The target in SI; a ratio as it is.
    std::optional<double> value() const { return m_value; }
    /// Shows another value in that unit, which bare numbers have too, without a signal. Text being typed
    /// stays if none of the three has changed.
    void present(std::optional<double> value, Quantity quantity, const Unit& unit);
    /// Why the text is no goal; empty when it is.
    const QString& problem() const { return m_problem; }
    /// "240 kN", as the command line takes it back. Requires a value.
    std::string commandText() const;

  signals:
    /// value() is another one.
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
