// SPDX-License-Identifier: GPL-3.0-or-later
// F6 and Shift+F6 take the keyboard round the areas of the window.
#pragma once

#include <QList>
#include <QObject>

class QMenu;
class QWidget;

namespace drillwave {

/// The focus comes back to where it was in an area. An area that is closed is passed over; one behind
/// another in a row of docks comes to the front.
class AreaKeys : public QObject {
    Q_OBJECT

  public:
    /// In the order of the keys.
    AreaKeys(QList<QWidget*> areas, QWidget* window);

    void addTo(QMenu& menu);
    /// Gives the focus to the next area, or to the one before by −1.
    void go(int step);

  private:
    bool enter(QWidget* area) const;

    QList<QWidget*> m_areas;
};

}  // namespace drillwave
