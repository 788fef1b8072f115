// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/string/string_cell_editor.h"

#include <QKeyEvent>

#include "core/model/section_parameter.h"
#include "ui/form/problem_plate.h"
#include "ui/form/quantity_field.h"
#include "ui/pages/string/string_model.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

// Why a document would not take the number.
QString objection(const Document& document, const KeptParameter& parameter, double si) {
    try {
        ScenarioDocument changed;
        return document.contentsWith({{parameter, si}}, changed);
    } catch (const ScenarioError& error) {
        return translated(error);
    }
}

// A cross-section is left by typing a diameter.
bool mayBeMissing(const SectionField& field) {
    return field.presence == Presence::optional && field.key != "area";
}

}  // namespace

StringCellEditor::StringCellEditor(const Document& document, StringModel& model, QObject* parent)
    : QStyledItemDelegate(parent), m_document(document), m_model(model) {}

QWidget* StringCellEditor::createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                                        const QModelIndex& index) const {
    return m_model.parameterAt(index) ? newField(parent, index)
                                      : QStyledItemDelegate::createEditor(parent, option, index);
}

QWidget* StringCellEditor::newField(QWidget* parent, const QModelIndex& index) const {
    const KeptParameter parameter = m_model.parameterAt(index);
    auto* field =
        new QuantityField(StringModel::ofColumn(parameter->address->field->key), m_document.units(), parent);
    field->setFrame(false);
    field->setButtonSymbols(QAbstractSpinBox::NoButtons);
    field->setAccessibleName(parameterLabel(*parameter));
    field->setToolTip(coreText(parameter->meaning));
    field->setAutoFillBackground(true);
    if (field->unitButton()) field->unitButton()->hide();
    if (mayBeMissing(*parameter->address->field)) field->setOptional(tr("not given"));
    field->setTaker([this, parameter](double si) { return objection(m_document, parameter, si); });
    auto* plate = new ProblemPlate(field);
    connect(field, &QObject::destroyed, plate, &QObject::deleteLater);
    connect(field, &QuantityField::problemShown, plate, [plate, parameter](const QString& problem) {
        if (problem.isEmpty())
            plate->hide();
        else
            plate->say(QStringLiteral("⚠ %1: %2").arg(parameterLabel(*parameter), problem));
    });
    return field;
}

void StringCellEditor::setEditorData(QWidget* editor, const QModelIndex& index) const {
    const KeptParameter parameter = m_model.parameterAt(index);
    auto* field = qobject_cast<QuantityField*>(editor);
    if (!field || !parameter) return QStyledItemDelegate::setEditorData(editor, index);
    const bool isFresh = !field->value() && field->text().isEmpty();
    field->setValue(parameter->value(m_document.scenario()));
    if (isFresh) field->selectAll();  // what is typed on a selected cell replaces its number
}

void StringCellEditor::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                            const QModelIndex& index) const {
    QStyledItemDelegate::updateEditorGeometry(editor, option, index);
    if (!qobject_cast<QuantityField*>(editor) || !editor->parentWidget()) return;
    constexpr int letters = 20;
    const int room = editor->parentWidget()->width();
    QRect place = option.rect;
    place.setWidth(
        std::min(std::max(place.width(), letters * editor->fontMetrics().averageCharWidth()), room));
    place.moveRight(std::min(place.right(), room - 1));
    editor->setGeometry(place);
}

void StringCellEditor::setModelData(QWidget* editor, QAbstractItemModel* model,
                                    const QModelIndex& index) const {
    auto* field = qobject_cast<QuantityField*>(editor);
    if (!field) return QStyledItemDelegate::setModelData(editor, model, index);
    if (!field->problem().isEmpty()) return;  // the cell shows its value again
    const KeptParameter parameter = m_model.parameterAt(index);
    const bool isNew =
        parameter && field->value() && field->value() != parameter->value(m_document.scenario());
    if (isNew) model->setData(index, *field->value());
    const bool isTakenAway = parameter && !field->value() && mayBeMissing(*parameter->address->field) &&
                             parameter->value(m_document.scenario());
    if (isTakenAway) model->setData(index, QVariant());
}

// Enter leaves a cell only with text that can be taken.
bool StringCellEditor::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const auto* field = qobject_cast<QuantityField*>(watched);
        if (field && (key == Qt::Key_Return || key == Qt::Key_Enter) && !field->problem().isEmpty())
            return false;  // the field shows why at once
    }
    return QStyledItemDelegate::eventFilter(watched, event);
}

}  // namespace drillwave
