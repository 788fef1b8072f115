// SPDX-License-Identifier: GPL-3.0-or-later
// Size and place of the window and its two docks, kept over the end of the program.
#pragma once

#include <QList>
#include <QObject>
#include <QSize>

class QDockWidget;
class QMainWindow;
class QMenu;
class QWidget;

namespace drillwave {

// F6 and Shift+F6 take the keyboard round the areas of the window.

/// The focus comes back to where it was in an area. An area that is closed is passed over; a hidden one in a
/// row of docks is raised.
class AreaKeys : public QObject {
    Q_OBJECT

  public:
    /// Takes the areas in the order of the keys.
    AreaKeys(QList<QWidget*> areas, QWidget* window);

    void addTo(QMenu& menu);
    /// Gives the focus to the next area, or to the one before by −1.
    void go(int step);

  private:
    bool enter(QWidget* area) const;

    QList<QWidget*> m_areas;
};

/// Side by side the docks leave a narrow window no room for the page: they share one side then.
class WindowLayout : public QObject {
    Q_OBJECT

  public:
    /// addDock() and restoreSize() come before the window is shown.
    explicit WindowLayout(QMainWindow* window);

    /// The first is on the left, the second on the right. `name` identifies it in the settings.
    QDockWidget* addDock(const QString& title, const QString& name, QWidget* content);
    /// Raises the dock of that content, and opens it if it was closed.
    void reveal(const QWidget* content);
    /// Docks to be shown or hidden, and everything to be put back.
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
    QSize m_firstSize;       // where there is none of the last run
    bool m_stacked = false;  // the docks share a side for want of room
};

}  // namespace drillwave
