// SPDX-License-Identifier: GPL-3.0-or-later
// A column of widgets to be scrolled, always as wide: its scroll bar is there whether it is needed or not.
#pragma once

#include <QScrollArea>

namespace drillwave {

/// Scrolls vertically only.
class SteadyScrollArea : public QScrollArea {
    Q_OBJECT

  public:
    explicit SteadyScrollArea(QWidget* parent = nullptr);

    QSize sizeHint() const override;
    /// Wide enough that nothing is cut off at the side.
    QSize minimumSizeHint() const override;

  protected:
    bool event(QEvent* event) override;

  private:
    QSize around(const QSize& content, int height) const;
};

}  // namespace drillwave
