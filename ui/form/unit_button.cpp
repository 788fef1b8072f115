// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/unit_button.h"

#include <QStyleOptionToolButton>
#include <QStylePainter>

namespace drillwave {
namespace {
constexpr int menuArrowSize = 8;
constexpr int margin = 4;
}  // namespace

UnitButton::UnitButton(QWidget* parent) : QToolButton(parent) {
    setAutoRaise(true);
    setPopupMode(QToolButton::InstantPopup);
    setFocusPolicy(Qt::ClickFocus);
}

QSize UnitButton::sizeHint() const {
    return {fontMetrics().horizontalAdvance(text()) + menuArrowSize + 3 * margin,
            fontMetrics().height() + 2 * margin};
}

// Styles put their mark of a menu into the corner, over the unit; here it stands behind it.
void UnitButton::paintEvent(QPaintEvent* /*event*/) {
    QStyleOptionToolButton option;
    initStyleOption(&option);
    option.features &= ~QStyleOptionToolButton::HasMenu;
    option.text.clear();
    QStylePainter painter(this);
    painter.drawComplexControl(QStyle::CC_ToolButton, option);
    const QRect inside = rect().adjusted(margin, 0, -margin, 0);
    painter.drawItemText(inside, Qt::AlignLeft | Qt::AlignVCenter, palette(), isEnabled(), text(),
                         QPalette::ButtonText);
    QStyleOption arrow = static_cast<const QStyleOption&>(option);
    arrow.rect = QRect(inside.right() - menuArrowSize + 1, (height() - menuArrowSize) / 2, menuArrowSize,
                       menuArrowSize);
    painter.drawPrimitive(QStyle::PE_IndicatorArrowDown, arrow);
}

}  // namespace drillwave
