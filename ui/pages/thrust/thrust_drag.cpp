// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/thrust/thrust_drag.h"

#include <QMouseEvent>
#include <cmath>

#include "ui/pages/thrust/thrust_plot.h"
#include "ui/plot/plot_widget.h"

namespace drillwave {
namespace {

constexpr double reach = 6;  // [px]

}  // namespace

ThrustDrag::ThrustDrag(PlotWidget& widget, const ThrustPlot& plot)
    : QObject(&widget), m_widget(widget), m_plot(plot) {
    widget.installEventFilter(this);
}

void ThrustDrag::setEnabled(bool enabled) {
    m_enabled = enabled;
    if (!enabled) m_dragging = false;
    if (!enabled) showHand(false);
}

bool ThrustDrag::isNear(QPointF pixel) const {
    const std::optional<double> height = m_enabled ? m_plot.heightAboveFeed(pixel) : std::nullopt;
    return height && std::abs(*height) <= reach;
}

void ThrustDrag::showHand(bool near) {
    if (near == m_hand) return;
    m_hand = near;
    if (near)
        m_widget.setCursor(Qt::SizeVerCursor);
    else
        m_widget.unsetCursor();
}

bool ThrustDrag::eventFilter(QObject* /*watched*/, QEvent* event) {
    if (event->type() == QEvent::Leave && !m_dragging) showHand(false);
    if (event->type() != QEvent::MouseButtonPress && event->type() != QEvent::MouseMove &&
        event->type() != QEvent::MouseButtonRelease)
        return false;
    const auto* mouse = static_cast<QMouseEvent*>(event);
    if (event->type() == QEvent::MouseButtonPress) {
        const bool plain = mouse->button() == Qt::LeftButton && mouse->modifiers() == Qt::NoModifier;
        if (!plain || !isNear(mouse->position())) return false;
        m_dragging = true;
        m_widget.markPoint(std::nullopt);  // what it says is of the line as it was
        m_grabbedAt = *m_plot.heightAboveFeed(mouse->position());
        m_widget.setFocus(Qt::MouseFocusReason);
        emit begun(m_widget.yAxis->pixelToCoord(mouse->position().y() + m_grabbedAt));
        return true;
    }
    if (m_dragging) {
        if (event->type() == QEvent::MouseButtonRelease)
            m_dragging = false;
        else
            emit moved(m_widget.yAxis->pixelToCoord(mouse->position().y() + m_grabbedAt));
        return true;
    }
    if (mouse->buttons() == Qt::NoButton) showHand(isNear(mouse->position()));
    return false;
}

}  // namespace drillwave
