// SPDX-License-Identifier: GPL-3.0-or-later
// Size and position of the window and its two docks, stored for later sessions.
#pragma once

#include <QList>
#include <QObject>
#include <QSize>

class QDockWidget;
class QMainWindow;
class QMenu;
class QWidget;

namespace drillwave {

// Moves the keyboard focus around the areas of the window by F6 and Shift+F6.

/// Menu actions (F6, Shift+F6) that move the keyboard focus from one area of the window to the next, such as
/// from input to plots. The widget that last had the focus in an area gets it again. Closed areas are
/// skipped; an area hidden by another dock is brought to the front.
class AreaKeys : public QObject {
    Q_OBJECT

  public:
    /// Creates the object for these areas, in the order in which F6 visits them.
    AreaKeys(QList<QWidget*> areas, QWidget* window);

    void addTo(QMenu& menu);
    /// Gives the keyboard focus to the next area of the window (step 1) or to the previous one (step −1).
    void go(int step);

  private:
    bool enter(QWidget* area) const;

    QList<QWidget*> m_areas;
};

/// Layout of the window with two docks beside the page, one on each side. In a narrow window both docks share
/// one side, to leave room for the page.
class WindowLayout : public QObject {
    Q_OBJECT

  public:
    /// Creates a layout without docks. Call addDock() for both docks, and restoreSize(), before the window is
    /// shown.
    explicit WindowLayout(QMainWindow* window);

    /// Adds a dock widget with `content`, and returns it. The first dock is on the left, the second on the
    /// right. `name` identifies it in the stored settings.
    QDockWidget* addDock(const QString& title, const QString& name, QWidget* content);
    /// Brings the dock with this content to the front, and opens it if it was closed.
    void reveal(const QWidget* content);
    /// Adds to `menu` the actions that show and hide the docks, and one that resets the layout.
    void addTo(QMenu& menu);
    void restoreSize();
    void save() const;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void restore();
    void reset();
    void stack();
    void setLeastWidths();
    void shareOneSide();
    int widthSideBySide() const;
    int widthOfOneSide() const;
    int widthOfSides() const;
    bool isSideBySide() const;

    QMainWindow* m_window;
    QList<QDockWidget*> m_docks;
    bool m_restored = false;
    QSize m_firstSize;       // initial size of the window if no size was stored
    bool m_stacked = false;  // true if the docks share one side because the window is narrow
};

}  // namespace drillwave
