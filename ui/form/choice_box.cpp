// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/choice_box.h"

#include <QAbstractItemView>
#include <QHelpEvent>
#include <QScrollBar>
#include <QStyleOptionComboBox>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>

namespace drillwave {
namespace {

constexpr int besideText = 4;  // which a style leaves free on both sides together

}  // namespace

ChoiceBox::ChoiceBox(QWidget* parent) : QComboBox(parent) {
    setFocusPolicy(Qt::StrongFocus);
    // Long names are cut off with an ellipsis rather than widening the panel.
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(12);
}

void ChoiceBox::followText() {
    m_followsText = true;
    connect(this, &QComboBox::currentTextChanged, this, &ChoiceBox::updateGeometry);
    updateGeometry();
}

int ChoiceBox::textWidth() const {
    return fontMetrics().horizontalAdvance(currentText()) + besideText;
}

QSize ChoiceBox::sizeHint() const {
    const QSize usual = QComboBox::sizeHint();
    if (!m_followsText) return usual;
    QStyleOptionComboBox option;
    initStyleOption(&option);
    const QSize text(textWidth(), fontMetrics().height());
    const QSize needed = style()->sizeFromContents(QStyle::CT_ComboBox, &option, text, this);
    return {std::max(needed.width(), minimumSizeHint().width()), usual.height()};
}

bool ChoiceBox::isCut() const {
    QStyleOptionComboBox option;
    initStyleOption(&option);
    const QRect field =
        style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this);
    return textWidth() > field.width() + besideText;
}

void ChoiceBox::showPopup() {
    view()->setMinimumWidth(view()->sizeHintForColumn(0) + view()->verticalScrollBar()->sizeHint().width());
    QComboBox::showPopup();
}

bool ChoiceBox::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip || !isCut()) return QComboBox::event(event);
    QString text = currentText();
    if (!toolTip().isEmpty()) text += QLatin1Char('\n') + toolTip();
    QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), text, this);
    return true;
}

void ChoiceBox::wheelEvent(QWheelEvent* event) {
    if (hasFocus())
        QComboBox::wheelEvent(event);
    else
        event->ignore();
}

}  // namespace drillwave
