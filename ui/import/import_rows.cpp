// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/import_rows.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "ui/text/translation.h"
#include "ui/text/unfocused_wheel.h"

namespace drillwave {
namespace {

void nameControl(QWidget& control, const RowWords& words) {
    control.setObjectName(QLatin1String(words.name));
    control.setToolTip(words.toolTip);
    control.setAccessibleName(words.label);
}

QString objection(FieldRange range, double si) {
    if (range == FieldRange::notNegative && si < 0) return tr("must not be negative");
    if (range == FieldRange::positive && !(si > 0)) return tr("must be greater than 0");
    if (range == FieldRange::notZero && si == 0) return tr("must not be 0");
    return {};
}

}  // namespace

ChoiceBox* addChoice(QFormLayout& form, const RowWords& words, const QList<RowChoice>& entries) {
    auto* box = new ChoiceBox(form.parentWidget());
    nameControl(*box, words);
    for (const RowChoice& entry : entries) box->addItem(entry.text, entry.value);
    form.addRow(words.label, box);
    return box;
}

void setEntries(ChoiceBox& box, const QList<RowChoice>& entries) {
    const QSignalBlocker quiet(box);
    const int before = chosenValue(box);
    box.clear();
    for (const RowChoice& entry : entries) box.addItem(entry.text, entry.value);
    box.setCurrentIndex(std::max(0, box.findData(before)));
}

void choose(ChoiceBox& box, int value) {
    const QSignalBlocker quiet(box);
    if (const int index = box.findData(value); index >= 0) box.setCurrentIndex(index);
}

int chosenValue(const ChoiceBox& box) {
    return box.currentData().toInt();
}

QuantityField* addQuantity(QFormLayout& form, const RowWords& words, Quantity quantity, const char* unit,
                           FieldRange range, std::optional<double> si, std::function<void()> changed) {
    auto* row = new QWidget(form.parentWidget());
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* field = new QuantityField(quantity, *findUnit(quantity, unit), row);
    nameControl(*field, words);
    field->setValue(si);
    QObject::connect(field, &QuantityField::problemShown, field, changed);
    QObject::connect(field, &QuantityField::cleared, field, changed);
    field->setTaker([range, changed = std::move(changed)](double value) {
        const QString refusal = objection(range, value);
        if (refusal.isEmpty()) changed();
        return refusal;
    });
    layout->addWidget(field, 1);
    if (field->unitButton()) {
        field->unitButton()->setAccessibleName(tr("%1: unit").arg(words.label));
        layout->addWidget(field->unitButton());
    }
    auto* label = new QLabel(words.label, form.parentWidget());
    label->setBuddy(field);
    form.addRow(label, row);
    return field;
}

QSpinBox* addCount(QFormLayout& form, const RowWords& words, int least, int most, int value) {
    auto* box = new QSpinBox(form.parentWidget());
    nameControl(*box, words);
    box->setRange(least, most);
    box->setValue(value);
    box->setKeyboardTracking(false);
    ignoreUnfocusedWheel(*box);
    form.addRow(words.label, box);
    return box;
}

void setRowVisible(QFormLayout& form, QWidget& control, bool visible) {
    QWidget* inForm = form.indexOf(&control) >= 0 ? &control : control.parentWidget();
    form.setRowVisible(inForm, visible);
}

}  // namespace drillwave
