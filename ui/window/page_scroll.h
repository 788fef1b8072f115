// SPDX-License-Identifier: GPL-3.0-or-later
// The room for the pages.
#pragma once

#include <QScrollArea>

namespace drillwave {

class PageTabs;

/// Scrolls a page that needs more room than the window has, so that all of it can be reached. A narrow window
/// scrolls it sideways too.
class PageScroll : public QScrollArea {
    Q_OBJECT

  public:
    static constexpr int leastWidth = 400;  ///< [px] below which the window does not go

    explicit PageScroll(PageTabs* pages, QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    /// The width [px] at which no page scrolls sideways.
    int neededWidth() const;
};

}  // namespace drillwave
