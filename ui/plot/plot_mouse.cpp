// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_mouse.h"

#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "ui/plot/legend_entries.h"
#include "ui/plot/plot_widget.h"

namespace drillwave {
namespace {

constexpr double zoomPerNotch = 0.85;
constexpr double wheelNotch = 120;
constexpr double hoverDistance = 12;  // [px]
constexpr double takeDistance = 10;   // [px]: a click farther from curves and marks takes no value
constexpr double clickDistance = 3;   // [px]: a press that moves less is a click

}  // namespace

void PlotMouse::wheel(const QWheelEvent& event) {
    const double notches = event.angleDelta().y() / wheelNotch;
    if (notches == 0 || !m_plot.view().zoomAt(event.position(), std::pow(zoomPerNotch, notches))) return;
    m_plot.setFocus(Qt::MouseFocusReason);  // Backspace is to bring the view back
    m_plot.markPoint(std::nullopt);
}

void PlotMouse::beforePress(const QMouseEvent& event) {
    const bool left = event.button() == Qt::LeftButton;
    const bool box = event.button() == Qt::RightButton || (left && event.modifiers() & Qt::ShiftModifier);
    m_pressed = event.position();
    m_plot.view().activateAt(m_pressed);
    m_gesture = box && m_plot.view().isInside(event.pos()) ? Gesture::box : Gesture::none;
    if (m_gesture == Gesture::box) m_plot.setSelectionRectMode(QCP::srmCustom);
}

void PlotMouse::press(const QMouseEvent& event) {
    if (event.button() == Qt::BackButton) return m_plot.view().goBack();
    if (m_gesture != Gesture::box && event.button() == Qt::LeftButton) {
        if (const auto cursor = m_plot.mover().grabAt(m_pressed)) {
            m_gesture = Gesture::cursor;
            m_grabbed = *cursor;
        } else {
            m_gesture = Gesture::pan;
            m_panning = false;
            m_plot.view().beginDrag(m_pressed);
        }
    }
    m_plot.markPoint(std::nullopt);
    m_plot.keyPoint().leave();
}

void PlotMouse::move(const QMouseEvent& event) {
    if (m_gesture == Gesture::cursor) {
        m_plot.mover().drag(m_grabbed, event.position().x());
    } else if (m_gesture == Gesture::pan) {
        m_panning = m_panning || (event.position() - m_pressed).manhattanLength() > clickDistance;
        if (m_panning) m_plot.view().dragTo(event.position());
    } else if (event.buttons() == Qt::NoButton) {
        hover(event.position());
    }
}

void PlotMouse::release(const QMouseEvent& event) {
    m_plot.setSelectionRectMode(QCP::srmNone);
    const Gesture ended = std::exchange(m_gesture, Gesture::none);
    m_plot.view().endDrag();
    if ((event.position() - m_pressed).manhattanLength() > clickDistance) return;
    if (event.button() == Qt::RightButton) return m_plot.openMenu(event.pos());
    if (event.button() == Qt::LeftButton && ended != Gesture::cursor) click(event);
}

void PlotMouse::doubleClick(const QMouseEvent& event) {
    if (QCPAbstractPlottable* curve = legendEntryAt(m_plot, event.position()))
        m_plot.setCurveVisible(curve, !curve->visible());
    else if (event.button() == Qt::LeftButton)
        m_plot.fit();
    // Its release does not count as a click.
    m_pressed = QPointF(-1e6, -1e6);
}

void PlotMouse::click(const QMouseEvent& event) {
    const QPoint point = event.pos();
    if (QCPAbstractPlottable* curve = legendEntryAt(m_plot, point))
        return m_plot.setCurveVisible(curve, !curve->visible());
    if (const auto near = nearestCurvePoint(m_plot, point, hoverDistance))
        if (auto* graph = qobject_cast<QCPGraph*>(near->curve)) m_plot.reader().setGraph(graph);
    QCPAxisRect* rect = m_plot.axisRectAt(point);
    if (!rect || !rect->rect().contains(point)) return;
    const QPointF place(rect->axis(QCPAxis::atBottom)->pixelToCoord(point.x()),
                        rect->axis(QCPAxis::atLeft)->pixelToCoord(point.y()));
    const bool takes =
        isOnCurve(m_plot, point, takeDistance) || m_plot.keyPoint().isOnMark(point, takeDistance);
    emit m_plot.clicked(rect, place, event.modifiers());
    if (takes) emit m_plot.placeTaken(rect, place, event.modifiers());
}

void PlotMouse::hover(QPointF point) {
    if (m_plot.mover().cursorAt(point))
        showPointer(Qt::SplitHCursor);
    else if (legendEntryAt(m_plot, point))
        showPointer(Qt::PointingHandCursor);
    else
        showPointer(Qt::ArrowCursor);
    const bool onCursor = m_plot.reader().cursors().cursorAt(point).has_value();
    m_plot.markPoint(onCursor ? std::nullopt : nearestCurvePoint(m_plot, point, hoverDistance));
}

// Leaves alone what a page has set.
void PlotMouse::showPointer(Qt::CursorShape shape) {
    if (shape == m_pointer) return;
    m_pointer = shape;
    if (shape == Qt::ArrowCursor)
        m_plot.unsetCursor();
    else
        m_plot.setCursor(shape);
}

}  // namespace drillwave
