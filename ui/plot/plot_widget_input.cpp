// SPDX-License-Identifier: GPL-3.0-or-later
// What mouse, wheel and keys do in a plot.
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <cmath>

#include "ui/plot/axis_view.h"
#include "ui/plot/legend_entries.h"
#include "ui/plot/plot_widget.h"

namespace drillwave {
namespace {

constexpr double zoomPerNotch = 0.85;
constexpr double wheelNotch = 120;
constexpr double zoomPerKey = 0.75;
constexpr double panPerKey = 0.1;     // of the view
constexpr double hoverDistance = 12;  // [px]
constexpr double clickDistance = 3;   // [px]: a press that moves less is a click
constexpr int leastBox = 6;           // [px]

double sideCenter(const QCPAxis& axis) {
    const QRect rect = axis.axisRect()->rect();
    return axis.orientation() == Qt::Horizontal ? rect.center().x() : rect.center().y();
}

double along(const QCPAxis& axis, QPointF point) {
    return axis.orientation() == Qt::Horizontal ? point.x() : point.y();
}

bool takesText(const QWidget& widget) {
    if (const auto* box = qobject_cast<const QComboBox*>(&widget)) return box->isEditable();
    return qobject_cast<const QLineEdit*>(&widget) || qobject_cast<const QAbstractSpinBox*>(&widget) ||
           qobject_cast<const PlotWidget*>(&widget);
}

}  // namespace

// The axes that a wheel or a drag at this point is about: the one below it, or both of the rect.
QList<QCPAxis*> PlotWidget::axesAt(QPointF point) const {
    QList<QCPAxis*> axes;
    for (const QCPAxisRect* rect : axisRects())
        for (const auto type : {QCPAxis::atBottom, QCPAxis::atLeft})
            if (QCPAxis* axis = rect->axis(type); axis && axis->selectTest(point, false) >= 0)
                axes.append(axis);
    if (!axes.isEmpty()) return axes;
    const QCPAxisRect* rect = axisRectAt(point);
    if (!rect || !rect->rect().contains(point.toPoint())) return {};
    return {rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft)};
}

QCPAxisRect* PlotWidget::activeRect() const {
    if (m_lastRect) return m_lastRect;
    return axisRectCount() > 0 ? axisRect(0) : nullptr;
}

void PlotWidget::wheelEvent(QWheelEvent* event) {
    emit mouseWheel(event);
    event->accept();
    const double notches = event->angleDelta().y() / wheelNotch;
    const QList<QCPAxis*> axes = axesAt(event->position());
    if (notches == 0 || axes.isEmpty()) return;
    setFocus(Qt::MouseFocusReason);  // Backspace is to bring the view back
    if (QCPAxisRect* below = axisRectAt(event->position())) m_lastRect = below;
    m_history.rememberBurst();
    for (QCPAxis* axis : axes)
        zoomAxis(*axis, std::pow(zoomPerNotch, notches), along(*axis, event->position()));
    m_hover.show(std::nullopt, {});
    replot(rpQueuedReplot);
}

void PlotWidget::mousePressEvent(QMouseEvent* event) {
    const bool left = event->button() == Qt::LeftButton;
    const bool box = event->button() == Qt::RightButton || (left && event->modifiers() & Qt::ShiftModifier);
    m_gesture = Gesture::none;
    m_pressed = event->position();
    if (QCPAxisRect* rect = axisRectAt(m_pressed)) m_lastRect = rect;
    const bool inside = m_lastRect && m_lastRect->rect().contains(event->pos());
    if (box && inside) setSelectionRectMode(QCP::srmCustom);
    QCustomPlot::mousePressEvent(event);
    if (event->button() == Qt::BackButton) return zoomBack();
    if (box && inside) {
        m_gesture = Gesture::box;
    } else if (const auto cursor = m_cursors.cursorAt(m_pressed);
               left && cursor && (*cursor != PlotCursor::time || offersTime())) {
        m_gesture = Gesture::cursor;
        m_grabbed = m_lastCursor = *cursor;
    } else if (left) {
        beginPan(m_pressed);
    }
    if (m_hover.show(std::nullopt, {})) replotOverlay();
}

void PlotWidget::mouseMoveEvent(QMouseEvent* event) {
    QCustomPlot::mouseMoveEvent(event);
    if (m_gesture == Gesture::cursor)
        dragCursor(m_grabbed, event->position().x());
    else if (m_gesture == Gesture::pan)
        pan(event->position());
    else if (event->buttons() == Qt::NoButton)
        hover(event->position());
}

void PlotWidget::mouseReleaseEvent(QMouseEvent* event) {
    const bool clicked = (event->position() - m_pressed).manhattanLength() <= clickDistance;
    QCustomPlot::mouseReleaseEvent(event);
    setSelectionRectMode(QCP::srmNone);
    const Gesture ended = m_gesture;
    m_gesture = Gesture::none;
    m_panned.clear();
    if (!clicked) return;
    if (event->button() == Qt::RightButton) return openMenu(event->pos());
    if (event->button() == Qt::LeftButton && ended != Gesture::cursor) click(event->pos());
}

void PlotWidget::mouseDoubleClickEvent(QMouseEvent* event) {
    QCustomPlot::mouseDoubleClickEvent(event);
    m_pressed = event->position();
    if (QCPAbstractPlottable* curve = legendEntryAt(*this, event->position()))
        setCurveVisible(curve, !curve->visible());
    else if (event->button() == Qt::LeftButton)
        fit();
    // Its release is no click of its own.
    m_pressed = QPointF(-1e6, -1e6);
}

void PlotWidget::click(QPoint point) {
    if (QCPAbstractPlottable* curve = legendEntryAt(*this, point))
        setCurveVisible(curve, !curve->visible());
    else if (const auto near = nearestCurvePoint(*this, point, hoverDistance))
        if (auto* graph = qobject_cast<QCPGraph*>(near->curve)) setReadGraph(graph);
}

void PlotWidget::beginPan(QPointF point) {
    m_panned.clear();
    m_panning = false;
    for (QCPAxis* axis : axesAt(point)) m_panned.append({axis, axis->range()});
    m_gesture = Gesture::pan;
}

void PlotWidget::pan(QPointF to) {
    if (!m_panning) {
        if ((to - m_pressed).manhattanLength() <= clickDistance) return;
        m_panning = true;
        m_history.remember();
    }
    for (const PannedAxis& panned : m_panned)
        if (panned.axis)
            panAxis(*panned.axis, panned.start, along(*panned.axis, m_pressed), along(*panned.axis, to));
    replot(rpQueuedReplot);
}

void PlotWidget::zoomToBox(const QRect& drawn) {
    const QRect box = drawn.normalized();
    if (!m_lastRect || box.width() < leastBox || box.height() < leastBox) return;
    m_history.remember();
    const QRect inside = box & m_lastRect->rect();
    zoomAxisTo(*m_lastRect->axis(QCPAxis::atBottom), inside.left(), inside.right());
    zoomAxisTo(*m_lastRect->axis(QCPAxis::atLeft), inside.top(), inside.bottom());
    replot(rpQueuedReplot);
}

// The axis rect in which pixels are times: the one clicked last, or the first with graphs.
QCPAxisRect* PlotWidget::cursorRect() const {
    const QList<QCPAxisRect*> rects = m_cursors.rects();
    if (rects.contains(m_lastRect)) return m_lastRect;
    return rects.value(0);
}

void PlotWidget::dragCursor(PlotCursor cursor, double pixel) {
    const QCPAxisRect* on = cursorRect();
    if (!on) return;
    const double kept = std::clamp<double>(pixel, on->rect().left(), on->rect().right());
    takeCursor(cursor, on->axis(QCPAxis::atBottom)->pixelToCoord(kept));
}

// The user wants the cursor at x.
void PlotWidget::takeCursor(PlotCursor cursor, double x) {
    m_lastCursor = cursor;
    placeCursor(cursor, x);
    if (cursor == PlotCursor::time) emit timeCursorDragged(x);
}

void PlotWidget::placeCursorByUser(PlotCursor cursor, std::optional<QPoint> at) {
    if (cursor == PlotCursor::time && !offersTime()) return;
    if (QCPAxisRect* below = at ? axisRectAt(*at) : nullptr) m_lastRect = below;
    const QCPAxisRect* on = cursorRect();
    if (!on) return;
    const bool beside = !at || at->x() < on->rect().left() || at->x() > on->rect().right();
    dragCursor(cursor, beside ? on->rect().center().x() : at->x());
}

void PlotWidget::moveLastCursor(double pixels) {
    const std::optional<double> x = cursorPosition(m_lastCursor);
    const QCPAxisRect* on = cursorRect();
    if (x && on) dragCursor(m_lastCursor, on->axis(QCPAxis::atBottom)->coordToPixel(*x) + pixels);
}

void PlotWidget::hover(QPointF point) {
    const auto cursor = m_cursors.cursorAt(point);
    if (cursor && (*cursor != PlotCursor::time || offersTime()))
        showPointer(Qt::SplitHCursor);
    else if (legendEntryAt(*this, point))
        showPointer(Qt::PointingHandCursor);
    else
        showPointer(Qt::ArrowCursor);
    const auto near = cursor ? std::nullopt : nearestCurvePoint(*this, point, hoverDistance);
    if (m_hover.show(near, near ? pointText(*near) : QString())) replotOverlay();
}

// Leaves alone what a page has set.
void PlotWidget::showPointer(Qt::CursorShape shape) {
    if (shape == m_pointer) return;
    m_pointer = shape;
    if (shape == Qt::ArrowCursor)
        unsetCursor();
    else
        setCursor(shape);
}

void PlotWidget::enterEvent(QEnterEvent* event) {
    QCustomPlot::enterEvent(event);
    qApp->installEventFilter(this);
}

// While the pointer is here.
bool PlotWidget::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress || !watched->isWidgetType() || watched == this) return false;
    const auto* widget = static_cast<QWidget*>(watched);
    if (widget->window() != window() || takesText(*widget)) return false;
    const auto& key = static_cast<const QKeyEvent&>(*event);
    const bool aimed =
        key.modifiers() == Qt::NoModifier && (key.key() == Qt::Key_Backspace || key.key() == Qt::Key_A ||
                                              key.key() == Qt::Key_B || key.key() == Qt::Key_T);
    return aimed && (cursorKey(key) || viewKey(key));
}

void PlotWidget::leaveEvent(QEvent* event) {
    QCustomPlot::leaveEvent(event);
    qApp->removeEventFilter(this);
    if (m_hover.show(std::nullopt, {})) replotOverlay();
}

void PlotWidget::keyPressEvent(QKeyEvent* event) {
    if (!cursorKey(*event) && !viewKey(*event)) QCustomPlot::keyPressEvent(event);
}

bool PlotWidget::cursorKey(const QKeyEvent& event) {
    const bool plain = !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    const QPoint pointer = mapFromGlobal(QCursor::pos());
    const auto at = rect().contains(pointer) ? std::optional(pointer) : std::nullopt;
    const double step = event.modifiers() & Qt::ShiftModifier ? 10 : 1;
    if (plain && event.key() == Qt::Key_A)
        placeCursorByUser(PlotCursor::a, at);
    else if (plain && event.key() == Qt::Key_B)
        placeCursorByUser(PlotCursor::b, at);
    else if (plain && event.key() == Qt::Key_T)
        placeCursorByUser(PlotCursor::time, at);
    else if (event.modifiers() & Qt::ControlModifier && event.key() == Qt::Key_Left)
        moveLastCursor(-step);
    else if (event.modifiers() & Qt::ControlModifier && event.key() == Qt::Key_Right)
        moveLastCursor(step);
    else
        return false;
    return true;
}

bool PlotWidget::viewKey(const QKeyEvent& event) {
    const int key = event.key();
    if (key == Qt::Key_Backspace || (key == Qt::Key_Left && event.modifiers() & Qt::AltModifier))
        zoomBack();
    else if (key == Qt::Key_F10 && event.modifiers() & Qt::ShiftModifier)
        openMenu(activeRect() ? activeRect()->center() : rect().center());
    else if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier))
        return false;
    else if (key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down)
        panByKey(key);
    else if (key == Qt::Key_Plus || key == Qt::Key_Equal)
        zoomByKey(zoomPerKey);
    else if (key == Qt::Key_Minus)
        zoomByKey(1 / zoomPerKey);
    else if (key == Qt::Key_Home)
        fit();
    else
        return false;
    return true;
}

void PlotWidget::panByKey(int key) {
    if (!activeRect()) return;
    const bool horizontal = key == Qt::Key_Left || key == Qt::Key_Right;
    QCPAxis* axis = activeRect()->axis(horizontal ? QCPAxis::atBottom : QCPAxis::atLeft);
    const QRect rect = activeRect()->rect();
    const double length = horizontal ? rect.width() : rect.height();
    const double shift = panPerKey * length * (key == Qt::Key_Left || key == Qt::Key_Up ? 1 : -1);
    m_history.rememberBurst();
    panAxis(*axis, axis->range(), sideCenter(*axis), sideCenter(*axis) + shift);
    replot(rpQueuedReplot);
}

void PlotWidget::zoomByKey(double factor) {
    if (!activeRect()) return;
    m_history.rememberBurst();
    for (const auto type : {QCPAxis::atBottom, QCPAxis::atLeft})
        if (QCPAxis* axis = activeRect()->axis(type)) zoomAxis(*axis, factor, sideCenter(*axis));
    replot(rpQueuedReplot);
}

void PlotWidget::focusInEvent(QFocusEvent* event) {
    QCustomPlot::focusInEvent(event);
    update();
}

void PlotWidget::focusOutEvent(QFocusEvent* event) {
    QCustomPlot::focusOutEvent(event);
    update();
}

void PlotWidget::paintEvent(QPaintEvent* event) {
    QCustomPlot::paintEvent(event);
    if (!hasFocus()) return;
    QPainter painter(this);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
    painter.drawRect(viewport().adjusted(1, 1, -1, -1));
}

}  // namespace drillwave
