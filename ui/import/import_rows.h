// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of a form of choices: each control with its label, name and explanation.
#pragma once

#include <QFormLayout>
#include <QSpinBox>
#include <functional>

#include "core/text/units.h"
#include "ui/form/choice_box.h"
#include "ui/form/quantity_field.h"

namespace drillwave {

/// What a row is called, and says of itself.
struct RowWords {
    const char* name;  ///< of the control, for tests
    QString label;
    QString toolTip;
};

/// An entry of a choice, and what it stands for.
struct RowChoice {
    QString text;
    int value = 0;
};

/// A choice of one of the entries.
ChoiceBox* addChoice(QFormLayout& form, const RowWords& words, const QList<RowChoice>& entries);
/// The entries anew; the value stays if there still is one of it, else the first is chosen. Tells nobody.
void setEntries(ChoiceBox& box, const QList<RowChoice>& entries);
/// Tells nobody; no effect where there is no such value.
void choose(ChoiceBox& box, int value);
int chosenValue(const ChoiceBox& box);

/// Which finite numbers a field takes.
enum class FieldRange { any, notNegative, positive, notZero };
/// `changed` is called with every value, and when its text is refused or is so no more.
QuantityField* addQuantity(QFormLayout& form, const RowWords& words, Quantity quantity, const char* unit,
                           FieldRange range, std::optional<double> si, std::function<void()> changed);

QSpinBox* addCount(QFormLayout& form, const RowWords& words, int least, int most, int value);

/// Of a control, its unit button with it.
void setRowVisible(QFormLayout& form, QWidget& control, bool visible);

}  // namespace drillwave
