// SPDX-License-Identifier: GPL-3.0-or-later
// Lies over a result that is not of the present input.
#pragma once

#include <QList>
#include <QWidget>

namespace drillwave {

/// Greys, hatches and names what is below, in any palette; mouse and keys go through. Hidden at first.
class StaleVeil : public QWidget {
    Q_OBJECT

  public:
    /// Lies over a widget, as its sibling, and follows it.
    explicit StaleVeil(QWidget* over);

    /// Lies over this sibling of the widget too, and over all between them.
    void cover(QWidget* sibling);
    /// Hides the result below completely, because it is that of another scenario.
    void setOpaque(bool opaque);

    /// The words on it.
    static QString words();

  protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void follow();

    QList<QWidget*> m_over;
    bool m_isOpaque = false;
};

}  // namespace drillwave
