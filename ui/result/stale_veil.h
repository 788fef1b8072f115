// SPDX-License-Identifier: GPL-3.0-or-later
// Lies over a result that is not of the present input.
#pragma once

#include <QWidget>

namespace drillwave {

/// Greys, hatches and names what is below, in any palette; mouse and keys go through. Hidden at first.
class StaleVeil : public QWidget {
    Q_OBJECT

  public:
    /// Lies over a widget, as its sibling, wherever that goes.
    explicit StaleVeil(QWidget* over);

    /// What is written on it.
    static QString words();

  protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    QWidget* m_over;
};

}  // namespace drillwave
