// SPDX-License-Identifier: GPL-3.0-or-later
// A translucent cover over results that do not belong to the present input.
#pragma once

#include <QList>
#include <QWidget>

namespace drillwave {

/// Cover over outdated results that greys, hatches and labels them, in any palette. Mouse and keys pass
/// through it. It is hidden at first.
class StaleVeil : public QWidget {
    Q_OBJECT

  public:
    /// Creates a cover over a widget, as its sibling, which follows the widget's size and place.
    explicit StaleVeil(QWidget* over);

    /// Extends the cover to a sibling of the widget, and over everything between them.
    void cover(QWidget* sibling);
    /// Sets whether the cover is opaque, which hides results of another scenario completely.
    void setOpaque(bool opaque);

    /// Returns the label of the cover.
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
