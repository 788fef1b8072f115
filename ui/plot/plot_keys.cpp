// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_keys.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>

#include "ui/plot/plot_widget.h"

namespace drillwave {
namespace {

constexpr double zoomPerKey = 0.75;
constexpr double panPerKey = 0.1;  // of the view
constexpr int coarseStep = 10;     // with Shift
constexpr Qt::KeyboardModifiers commandKeys = Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier;

bool takesText(const QWidget& widget) {
    if (const auto* box = qobject_cast<const QComboBox*>(&widget)) return box->isEditable();
    return qobject_cast<const QLineEdit*>(&widget) || qobject_cast<const QAbstractSpinBox*>(&widget) ||
           qobject_cast<const PlotWidget*>(&widget);
}

}  // namespace

PlotKeys::PlotKeys(PlotWidget& plot) : QObject(&plot), m_plot(plot) {}

void PlotKeys::followPointer(bool isHere) {
    if (isHere)
        qApp->installEventFilter(this);
    else
        qApp->removeEventFilter(this);
}

bool PlotKeys::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress || !watched->isWidgetType() || watched == &m_plot) return false;
    const auto* widget = static_cast<QWidget*>(watched);
    if (widget->window() != m_plot.window() || takesText(*widget)) return false;
    const auto& key = static_cast<const QKeyEvent&>(*event);
    const bool aimed =
        key.modifiers() == Qt::NoModifier && (key.key() == Qt::Key_Backspace || key.key() == Qt::Key_A ||
                                              key.key() == Qt::Key_B || key.key() == Qt::Key_T);
    return aimed && press(key);
}

bool PlotKeys::press(const QKeyEvent& event) {
    return pointKey(event) || cursorKey(event) || viewKey(event);
}

bool PlotKeys::pointKey(const QKeyEvent& event) {
    KeyPoint& point = m_plot.keyPoint();
    if (!point.isOffered() || event.modifiers() & commandKeys) return false;
    const bool isEnter = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
    const Qt::KeyboardModifiers shift = event.modifiers() & Qt::ShiftModifier;
    if (!point.place()) {
        if (isEnter) point.enter();
        return isEnter;
    }
    const int step = shift ? coarseStep : 1;
    switch (event.key()) {
        case Qt::Key_Return:
        case Qt::Key_Enter:
            point.take(shift);
            return true;
        case Qt::Key_Escape:
            point.leave();
            return true;
        case Qt::Key_Left:
        case Qt::Key_Right:
            point.move(event.key() == Qt::Key_Right ? step : -step, 0);
            return true;
        case Qt::Key_Up:
        case Qt::Key_Down:
            point.move(0, event.key() == Qt::Key_Up ? step : -step);
            return true;
        case Qt::Key_Home:
        case Qt::Key_End:
            point.goToEnd(event.key() == Qt::Key_End);
            return true;
        case Qt::Key_N:
            return point.goToMark(!shift);
        default:
            return false;
    }
}

bool PlotKeys::cursorKey(const QKeyEvent& event) {
    const bool plain = !(event.modifiers() & commandKeys);
    const QPoint pointer = m_plot.mapFromGlobal(QCursor::pos());
    auto at = m_plot.rect().contains(pointer) ? std::optional(pointer) : std::nullopt;
    if (const std::optional<QPointF> pixel = m_plot.keyPoint().pixel()) at = pixel->toPoint();
    const double step = event.modifiers() & Qt::ShiftModifier ? coarseStep : 1;
    if (plain && event.key() == Qt::Key_A)
        m_plot.mover().placeAt(PlotCursor::a, at);
    else if (plain && event.key() == Qt::Key_B)
        m_plot.mover().placeAt(PlotCursor::b, at);
    else if (plain && event.key() == Qt::Key_T)
        m_plot.mover().placeAt(PlotCursor::time, at);
    else if (event.modifiers() & Qt::ControlModifier && event.key() == Qt::Key_Left)
        m_plot.mover().step(-step);
    else if (event.modifiers() & Qt::ControlModifier && event.key() == Qt::Key_Right)
        m_plot.mover().step(step);
    else
        return false;
    return true;
}

bool PlotKeys::viewKey(const QKeyEvent& event) {
    const int key = event.key();
    if (key == Qt::Key_Backspace || (key == Qt::Key_Left && event.modifiers() & Qt::AltModifier))
        m_plot.view().goBack();
    else if (key == Qt::Key_F10 && event.modifiers() & Qt::ShiftModifier)
        m_plot.openMenu();
    else if (event.modifiers() & commandKeys)
        return false;
    else if (key == Qt::Key_Plus || key == Qt::Key_Equal)
        m_plot.view().zoom(zoomPerKey);
    else if (key == Qt::Key_Minus)
        m_plot.view().zoom(1 / zoomPerKey);
    else if (key == Qt::Key_Home)
        m_plot.fit();
    else
        return arrowKey(key);
    return true;
}

bool PlotKeys::arrowKey(int key) {
    if (key == Qt::Key_Left || key == Qt::Key_Right)
        m_plot.view().pan(Qt::Horizontal, key == Qt::Key_Left ? panPerKey : -panPerKey);
    else if (key == Qt::Key_Up || key == Qt::Key_Down)
        m_plot.view().pan(Qt::Vertical, key == Qt::Key_Up ? panPerKey : -panPerKey);
    else
        return false;
    return true;
}

}  // namespace drillwave
