// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/result/stale_veil.h"

#include <QEvent>
#include <QPainter>

namespace drillwave {
namespace {

constexpr int greyness = 165;   // of 255: what is below can be made out, and no more
constexpr int hatchStep = 14;   // [px]
constexpr int plateMargin = 6;  // [px]

}  // namespace

StaleVeil::StaleVeil(QWidget* over) : QWidget(over->parentWidget()), m_over(over) {
    setObjectName(QStringLiteral("staleVeil"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    setAccessibleName(words());
    setGeometry(over->geometry());
    over->installEventFilter(this);
    hide();
}

QString StaleVeil::words() {
    return tr("not of the present input");
}

bool StaleVeil::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ParentChange && m_over->parentWidget()) setParent(m_over->parentWidget());
    if (event->type() == QEvent::Resize || event->type() == QEvent::Move) setGeometry(m_over->geometry());
    return QWidget::eventFilter(watched, event);
}

void StaleVeil::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    QColor grey = palette().color(QPalette::Window);
    grey.setAlpha(greyness);
    painter.fillRect(rect(), grey);
    QColor line = palette().color(QPalette::WindowText);
    line.setAlpha(40);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(line, 1));
    for (int x = -height(); x < width(); x += hatchStep) painter.drawLine(x, height(), x + height(), 0);

    const QRect text = fontMetrics().boundingRect(rect(), Qt::AlignHCenter | Qt::TextWordWrap, words());
    QRect plate = text.adjusted(-2 * plateMargin, 0, 2 * plateMargin, 2 * plateMargin);
    plate.moveCenter({rect().center().x(), 0});
    plate.moveTop(plateMargin);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.setBrush(palette().color(QPalette::Window));
    painter.drawRoundedRect(plate, 3, 3);
    painter.drawText(plate, Qt::AlignCenter | Qt::TextWordWrap, words());
}

}  // namespace drillwave
