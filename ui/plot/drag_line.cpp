// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/drag_line.h"

#include <QMouseEvent>
#include <cmath>

#include "ui/plot/axis_rect.h"
#include "ui/plot/plot_widget.h"

namespace drillwave {
namespace {

constexpr double dragReach = 6;    // [px]
constexpr double nameFrom = 0.86;  // of the height, from the top

}  // namespace

DragLine::DragLine(QCustomPlot& plot, QCPAxisRect* rect)
    : QObject(&plot),
      m_plot(plot),
      m_rect(rect),
      m_line(addItem<QCPItemStraightLine>(rect, QStringLiteral("legend"))),
      m_name(addItem<QCPItemText>(rect, QStringLiteral("legend"))) {
    for (QCPItemPosition* end : m_line->positions()) end->setTypeY(QCPItemPosition::ptAxisRectRatio);
    m_name->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
    m_name->setPositionAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_name->setPadding(QMargins(3, 1, 5, 1));
    hide();
    plot.installEventFilter(this);
}

void DragLine::present(const QString& name, double x, std::optional<double> snap) {
    m_snap = snap;
    m_name->setText(name);
    if (!m_isDragged) m_x = x;
    m_line->setVisible(true);
    m_name->setVisible(true);
    place();
}

void DragLine::hide() {
    m_line->setVisible(false);
    m_name->setVisible(false);
    m_isDragged = false;
    showHand(false);
}

void DragLine::setStyle(const PlotStyle& style) {
    m_line->setPen(QPen(style.text, 1.2, Qt::DashLine));
    m_name->setFont(style.font);
    m_name->setColor(style.text);
    m_name->setBrush(style.behindWords());
}

void DragLine::place() {
    m_line->point1->setCoords(m_x, 0);
    m_line->point2->setCoords(m_x, 1);
    m_name->position->setCoords(m_x, nameFrom);
}

bool DragLine::isNear(QPointF pixel) const {
    return m_line->visible() && m_rect->rect().contains(pixel.toPoint()) &&
           std::abs(pixel.x() - pixelOf(m_x)) <= dragReach;
}

void DragLine::moveTo(double pixel) {
    const bool snaps = m_snap && std::abs(pixelOf(*m_snap) - pixel) <= dragReach;
    m_x = snaps ? *m_snap : m_rect->axis(QCPAxis::atBottom)->pixelToCoord(pixel);
    place();
    m_plot.replot(QCustomPlot::rpQueuedReplot);
}

void DragLine::showHand(bool isNear) {
    if (isNear == m_hasHand) return;
    m_hasHand = isNear;
    if (isNear)
        m_plot.setCursor(Qt::SizeHorCursor);
    else
        m_plot.unsetCursor();
}

bool DragLine::eventFilter(QObject* /*watched*/, QEvent* event) {
    if (event->type() == QEvent::Leave && !m_isDragged) showHand(false);
    if (event->type() != QEvent::MouseButtonPress && event->type() != QEvent::MouseMove &&
        event->type() != QEvent::MouseButtonRelease)
        return false;
    const auto* mouse = static_cast<QMouseEvent*>(event);
    if (event->type() == QEvent::MouseButtonPress) {
        const bool isPlain = mouse->button() == Qt::LeftButton && mouse->modifiers() == Qt::NoModifier;
        if (!isPlain || !isNear(mouse->position())) return false;
        m_isDragged = true;
        if (auto* widget = qobject_cast<PlotWidget*>(&m_plot)) widget->markPoint(std::nullopt);
        m_plot.setFocus(Qt::MouseFocusReason);
        return true;
    }
    if (m_isDragged) {
        moveTo(mouse->position().x());
        if (event->type() == QEvent::MouseButtonRelease) {
            m_isDragged = false;
            emit released(m_x);
        } else {
            emit moved(m_x);
        }
        return true;
    }
    if (mouse->buttons() == Qt::NoButton) showHand(isNear(mouse->position()));
    return false;
}

}  // namespace drillwave
