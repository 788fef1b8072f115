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

StaleVeil::StaleVeil(QWidget* over) : QWidget(over->parentWidget()) {
    setObjectName(QStringLiteral("staleVeil"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    setAccessibleName(words());
    cover(over);
    hide();
}

void StaleVeil::cover(QWidget* sibling) {
    m_over.append(sibling);
    sibling->installEventFilter(this);
    follow();
}

void StaleVeil::setOpaque(bool opaque) {
    m_isOpaque = opaque;
    update();
}

void StaleVeil::follow() {
    QRect all;
    for (const QWidget* over : m_over)
        if (!over->isHidden()) all = all.united(over->geometry());
    setGeometry(all);
}

QString StaleVeil::words() {
    return tr("result of an earlier input");
}

bool StaleVeil::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ParentChange && m_over.first()->parentWidget())
        setParent(m_over.first()->parentWidget());
    if (event->type() == QEvent::Resize || event->type() == QEvent::Move) follow();
    return QWidget::eventFilter(watched, event);
}

void StaleVeil::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    QColor grey = palette().color(QPalette::Window);
    grey.setAlpha(m_isOpaque ? 255 : greyness);
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
