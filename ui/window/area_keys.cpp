// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/area_keys.h"

#include <QApplication>
#include <QDockWidget>
#include <QMenu>
#include <algorithm>

namespace drillwave {
namespace {

// The widget in an area that had the focus last, or the first that can have it; nullptr where there is none.
QWidget* focusOf(QWidget* area) {
    const auto takesFocus = [area](const QWidget* widget) {
        return widget->isEnabled() && widget->isVisibleTo(area) && (widget->focusPolicy() & Qt::TabFocus);
    };
    QWidget* last = area->focusWidget();
    if (last && area->isAncestorOf(last) && takesFocus(last)) return last;
    for (QWidget* next = area->nextInFocusChain(); next != area; next = next->nextInFocusChain())
        if (area->isAncestorOf(next) && takesFocus(next)) return next;
    return takesFocus(area) ? area : nullptr;
}

}  // namespace

AreaKeys::AreaKeys(QList<QWidget*> areas, QWidget* window) : QObject(window), m_areas(std::move(areas)) {}

void AreaKeys::addTo(QMenu& menu) {
    menu.addAction(tr("Next &area"), QKeySequence(Qt::Key_F6), this, [this] { go(1); });
    menu.addAction(tr("Pre&vious area"), QKeySequence(Qt::SHIFT | Qt::Key_F6), this, [this] { go(-1); });
}

// From outside all areas, such as the tabs, one comes to the first or the last.
void AreaKeys::go(int step) {
    const QWidget* focus = QApplication::focusWidget();
    const auto holds = [focus](const QWidget* area) { return area == focus || area->isAncestorOf(focus); };
    const auto found = focus ? std::ranges::find_if(m_areas, holds) : m_areas.end();
    qsizetype at = found != m_areas.end() ? found - m_areas.begin() : step > 0 ? -1 : m_areas.size();
    for (qsizetype tries = 0; tries < m_areas.size(); ++tries) {
        at = (at + step + m_areas.size()) % m_areas.size();
        if (enter(m_areas[at])) return;
    }
}

bool AreaKeys::enter(QWidget* area) const {
    auto* dock = qobject_cast<QDockWidget*>(area->parentWidget());
    if (dock && !dock->toggleViewAction()->isChecked()) return false;
    if (dock) dock->raise();
    QWidget* focus = focusOf(area);
    if (!focus) return false;
    focus->window()->activateWindow();
    focus->setFocus(Qt::TabFocusReason);
    return true;
}

}  // namespace drillwave
