// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/curve/goal_field.h"

#include "ui/text/shown_text.h"
#include "ui/text/typed_quantity.h"
#include "ui/text/typed_text.h"

namespace drillwave {

GoalField::GoalField(QWidget* parent) : QLineEdit(parent), m_unit(&unitsOf(Quantity::ratio).front()) {
    setObjectName(QStringLiteral("goal"));
    setAccessibleName(tr("Goal: wanted result"));
    setPlaceholderText(tr("none"));
    setClearButtonEnabled(true);
    setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("0.0000 MN/m")) + 40);
    setMaximumWidth(2 * minimumWidth());
    presentProblem();
    connect(this, &QLineEdit::editingFinished, this, &GoalField::read);
    connect(this, &QLineEdit::textChanged, this, [this](const QString& text) {
        if (text.isEmpty() && !hasFocus()) return;
        if (text.isEmpty()) read();  // by its button
    });
}

void GoalField::present(std::optional<double> value, Quantity quantity, const Unit& unit) {
    if (value == m_value && quantity == m_quantity && &unit == m_unit) return;
    m_value = value;
    m_quantity = quantity;
    m_unit = &unit;
    QString shown;
    if (value) {
        shown = fieldText(*value, quantity, unit, locale());
        if (!unit.name.empty()) shown += QLatin1Char(' ') + shownUnitName(unit.name);
    }
    setText(shown);
    m_problem.clear();
    presentProblem();
}

void GoalField::read() {
    std::optional<double> value;
    m_problem.clear();
    if (!text().trimmed().isEmpty()) {
        const TypedQuantity typed = typedQuantity(text(), m_quantity, *m_unit, locale());
        if (typed.valid())
            value = typed.si;
        else
            m_problem = translated(typed.problem);
    }
    presentProblem();
    if (!m_problem.isEmpty() || value == m_value) return;
    m_value = value;
    emit changed();
}

void GoalField::presentProblem() {
    setToolTip(
        m_problem.isEmpty()
            ? tr("Wanted result: the values of the parameter that give it are marked, and a click takes one")
            : QStringLiteral("⚠ ") + m_problem);
    setAccessibleDescription(toolTip());
    setStyleSheet(m_problem.isEmpty() ? QString()
                                      : QStringLiteral("QLineEdit { border: 2px solid #c62828; }"));
}

std::string GoalField::commandText() const {
    return formatQuantity(*m_value, m_quantity, *m_unit);
}

}  // namespace drillwave
