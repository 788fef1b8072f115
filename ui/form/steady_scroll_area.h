// SPDX-License-Identifier: GPL-3.0-or-later
// A column of widgets to be scrolled, as wide with a scroll bar as without.
#pragma once

#include <QScrollArea>

namespace drillwave {

/// Scrolls vertically only. The place of the scroll bar stays empty while there is none.
class SteadyScrollArea : public QScrollArea {
    Q_OBJECT

  public:
    explicit SteadyScrollArea(QWidget* parent = nullptr);

  protected:
    void resizeEvent(QResizeEvent* event) override;
};

}  // namespace drillwave
