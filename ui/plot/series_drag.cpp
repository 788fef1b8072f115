// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/series_drag.h"

#include <QMouseEvent>
#include <cmath>

#include "ui/plot/plot_widget.h"

namespace drillwave {
namespace {

constexpr double grasp = 6;  // [px]

}  // namespace

SeriesDrag::SeriesDrag(QCustomPlot& plot) : QObject(&plot), m_plot(plot) {
    plot.installEventFilter(this);
}

void SeriesDrag::setCurve(QCPGraph* curve) {
    m_curve = curve;
    if (curve) return;
    m_dragging = false;
    showHand(false);
}

std::optional<double> SeriesDrag::heightAbove(QPointF pixel) const {
    if (!m_curve || !m_curve->keyAxis()->axisRect()->rect().contains(pixel.toPoint())) return std::nullopt;
    const double at = m_curve->keyAxis()->pixelToCoord(pixel.x());
    const auto next = m_curve->data()->findBegin(at, false);
    if (next == m_curve->data()->constEnd() || next == m_curve->data()->constBegin()) return std::nullopt;
    const auto before = std::prev(next);
    const double share = (at - before->key) / (next->key - before->key);
    return m_curve->valueAxis()->coordToPixel(before->value + share * (next->value - before->value)) -
           pixel.y();
}

bool SeriesDrag::isNear(QPointF pixel) const {
    const std::optional<double> height = heightAbove(pixel);
    return height && std::abs(*height) <= grasp;
}

double SeriesDrag::valueAt(QPointF pixel) const {
    return m_curve->valueAxis()->pixelToCoord(pixel.y() + m_grabbedAt);
}

void SeriesDrag::showHand(bool near) {
    if (near == m_hand) return;
    m_hand = near;
    if (near)
        m_plot.setCursor(Qt::SizeVerCursor);
    else
        m_plot.unsetCursor();
}

bool SeriesDrag::eventFilter(QObject* /*watched*/, QEvent* event) {
    if (event->type() == QEvent::Leave && !m_dragging) showHand(false);
    if (event->type() != QEvent::MouseButtonPress && event->type() != QEvent::MouseMove &&
        event->type() != QEvent::MouseButtonRelease)
        return false;
    const auto* mouse = static_cast<QMouseEvent*>(event);
    if (event->type() == QEvent::MouseButtonPress) {
        const bool plain = mouse->button() == Qt::LeftButton && mouse->modifiers() == Qt::NoModifier;
        if (!plain || !isNear(mouse->position())) return false;
        m_dragging = true;
        // The reading there is of the curve as it was.
        if (auto* widget = qobject_cast<PlotWidget*>(&m_plot)) widget->markPoint(std::nullopt);
        m_grabbedAt = *heightAbove(mouse->position());
        m_plot.setFocus(Qt::MouseFocusReason);
        emit begun(valueAt(mouse->position()));
        return true;
    }
    if (m_dragging) {
        if (event->type() == QEvent::MouseButtonRelease)
            m_dragging = false;
        else
            emit moved(valueAt(mouse->position()));
        return true;
    }
    if (mouse->buttons() == Qt::NoButton) showHand(isNear(mouse->position()));
    return false;
}

}  // namespace drillwave
