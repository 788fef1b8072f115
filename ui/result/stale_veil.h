// SPDX-License-Identifier: GPL-3.0-or-later
// A translucent cover over results that do not belong to the present input.
#pragma once

#include <QList>
#include <QWidget>

namespace drillwave {

/// Cover over outdated results that greys and hatches them, and labels them as outdated. Mouse and keys pass
/// through it. It is hidden at first.
class StaleVeil : public QWidget {
    Q_OBJECT

  public:
    /// Creates a cover over a widget, as its sibling, which follows the widget's size and place.
    explicit StaleVeil(QWidget* over);

    /// Extends the cover so that it also covers `sibling`, a sibling of the covered widget, and everything
    /// between them.
    void cover(QWidget* sibling);
    /// Sets whether the cover is opaque. An opaque cover hides the results below completely, for example if
    /// they belong to another scenario.
    void setOpaque(bool opaque);

    /// Returns the text on the cover, such as "result of an earlier input".
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
