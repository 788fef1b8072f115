// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/window_layout.h"

#include <QApplication>
#include <QDockWidget>
#include <QEvent>
#include <QMainWindow>
#include <QMenu>
#include <QStyle>
#include <QTimer>
#include <algorithm>

#include "ui/questions/on_screen.h"
#include "ui/text/settings.h"
#include "ui/window/page_tabs.h"

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

// Raised when docks or toolbars change so that an old layout no longer fits.
constexpr int layoutVersion = 2;
constexpr QSize usualSize{1440, 900};
constexpr double leastPageShare = 0.45;  // of the window's width, where the docks can give way
constexpr int usefulPageWidth = 480;     // in a narrower page, a plot between both docks can hardly be read
const QString geometryKey = QStringLiteral("window/geometry");
const QString layoutKey = QStringLiteral("window/layout");
const QString stackedKey = QStringLiteral("window/stacked");
constexpr Qt::DockWidgetArea areas[] = {Qt::LeftDockWidgetArea, Qt::RightDockWidgetArea};

}  // namespace

AreaKeys::AreaKeys(QList<QWidget*> areas, QWidget* window) : QObject(window), m_areas(std::move(areas)) {}

void AreaKeys::addTo(QMenu& menu) {
    menu.addAction(tr("Next &area"), QKeySequence(Qt::Key_F6), this, [this] { go(1); });
    menu.addAction(tr("Pre&vious area"), QKeySequence(Qt::SHIFT | Qt::Key_F6), this, [this] { go(-1); });
}

// From outside all areas, such as the tabs, the focus goes to the first or the last.
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

WindowLayout::WindowLayout(QMainWindow* window) : QObject(window), m_window(window) {
    window->installEventFilter(this);
}

QDockWidget* WindowLayout::addDock(const QString& title, const QString& name, QWidget* content) {
    auto* dock = new QDockWidget(title, m_window);
    dock->setObjectName(name);
    dock->setWidget(content);
    m_window->addDockWidget(areas[m_docks.size()], dock);
    m_docks.append(dock);
    // Side by side they would widen a window that should be small at first.
    if (m_docks.size() == 2) shareOneSide();
    return dock;
}

void WindowLayout::reveal(const QWidget* content) {
    for (QDockWidget* dock : std::as_const(m_docks)) {
        if (dock->widget() != content) continue;
        dock->show();
        dock->raise();
    }
}

void WindowLayout::addTo(QMenu& menu) {
    for (const QDockWidget* dock : std::as_const(m_docks)) menu.addAction(dock->toggleViewAction());
    menu.addAction(tr("&Reset layout"), this, &WindowLayout::reset);
}

void WindowLayout::restoreSize() {
    // The frame is known only later, perhaps too late to be looked at.
    m_window->resize(firstSize(*m_window, usualSize));
    if (m_window->restoreGeometry(Settings().value(geometryKey).toByteArray()))
        keepOnScreen(*m_window);
    else
        m_firstSize = m_window->size();
}

void WindowLayout::save() const {
    Settings settings;
    settings.setValue(geometryKey, m_window->saveGeometry());
    settings.setValue(layoutKey, m_window->saveState(layoutVersion));
    settings.setValue(stackedKey, m_stacked);
}

// Restored before the window is shown, docks come out in wrong sizes.
bool WindowLayout::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Show && !std::exchange(m_restored, true))
        QTimer::singleShot(0, this, &WindowLayout::restore);
    if ((event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest) && m_restored &&
        !m_docks.isEmpty())
        setLeastWidths();  // before the window lays itself out
    if (event->type() == QEvent::Resize && m_restored) QTimer::singleShot(0, this, &WindowLayout::stack);
    return QObject::eventFilter(watched, event);
}

void WindowLayout::restore() {
    if (m_window->restoreState(Settings().value(layoutKey).toByteArray(), layoutVersion))
        m_stacked = Settings().value(stackedKey).toBool();
    else
        reset();
    for (QDockWidget* dock : std::as_const(m_docks))
        if (dock->isFloating()) keepOnScreen(*dock);
    stack();
    if (m_window->size() == m_firstSize) fitOnScreen(*m_window);  // only now its frame is known
}

void WindowLayout::reset() {
    for (QDockWidget* dock : std::as_const(m_docks)) {
        dock->setFloating(false);
        dock->show();
    }
    if (m_window->width() < widthSideBySide()) return shareOneSide();
    m_stacked = false;
    QList<int> widths;
    for (qsizetype i = 0; i < m_docks.size(); ++i) {
        m_window->addDockWidget(areas[i], m_docks[i]);
        widths.append(m_docks[i]->widget()->sizeHint().width());
    }
    m_window->resizeDocks(m_docks, widths, Qt::Horizontal);
}

bool WindowLayout::isSideBySide() const {
    return !m_docks[0]->isFloating() && !m_docks[1]->isFloating() && m_docks[0]->isVisible() &&
           m_docks[1]->isVisible() &&
           m_window->dockWidgetArea(m_docks[0]) != m_window->dockWidgetArea(m_docks[1]);
}

void WindowLayout::shareOneSide() {
    m_window->addDockWidget(areas[0], m_docks[0]);
    m_window->tabifyDockWidget(m_docks[0], m_docks[1]);
    m_docks[0]->raise();
    m_stacked = true;
}

// Returns the width that both docks and a useful page need.
int WindowLayout::widthSideBySide() const {
    // One more than the least: in a window that is as narrow as possible the docks share one
    // side.
    const auto* pages = m_window->centralWidget()->findChild<PageScroll*>();
    int width = std::max(usefulPageWidth, pages->neededWidth() + 1);
    for (const QDockWidget* dock : std::as_const(m_docks))
        width += dock->widget()->minimumSizeHint().width() +
                 m_window->style()->pixelMetric(QStyle::PM_DockWidgetSeparatorExtent);
    return width;
}

// The width that docks on one side and the separator take at least.
int WindowLayout::widthOfOneSide() const {
    int width = 0;
    for (const QDockWidget* dock : std::as_const(m_docks))
        if (!dock->isFloating() && !dock->isHidden())
            width = std::max(width, dock->widget()->minimumSizeHint().width());
    return width + m_window->style()->pixelMetric(QStyle::PM_DockWidgetSeparatorExtent);
}

// The width that docks on both sides and their separators take at least.
int WindowLayout::widthOfSides() const {
    int width = 0;
    for (const Qt::DockWidgetArea area : areas) {
        int widest = 0;
        for (QDockWidget* dock : std::as_const(m_docks))
            if (!dock->isFloating() && !dock->isHidden() && m_window->dockWidgetArea(dock) == area)
                widest = std::max(widest, dock->widget()->minimumSizeHint().width());
        if (widest > 0)
            width += widest + m_window->style()->pixelMetric(QStyle::PM_DockWidgetSeparatorExtent);
    }
    return width;
}

// The window may be made narrow at once, whatever the docks need side by side: they come together when it is.
// A dock shrinks before the page scrolls sideways, and before its sentences fill its height.
void WindowLayout::setLeastWidths() {
    auto* pages = m_window->centralWidget()->findChild<PageScroll*>();
    m_window->setMinimumWidth(PageScroll::leastWidth + widthOfOneSide());
    const int wanted = std::max(pages->neededWidth(), int(leastPageShare * m_window->width()));
    pages->setMinimumWidth(
        std::max(PageScroll::leastWidth, std::min(m_window->width() - widthOfSides(), wanted)));
}

void WindowLayout::stack() {
    if (!m_stacked && m_window->width() < widthSideBySide() && isSideBySide()) {
        shareOneSide();
    } else if (m_stacked && m_window->width() >= widthSideBySide()) {
        m_stacked = false;
        m_window->addDockWidget(areas[1], m_docks[1]);
    }
}

}  // namespace drillwave
