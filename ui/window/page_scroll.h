// SPDX-License-Identifier: GPL-3.0-or-later
// The room for the pages.
#pragma once

#include <QScrollArea>

namespace drillwave {

class PageTabs;

/// Scrolls a page that needs more height than the window has, so that all of it can be reached. In width the
/// window has room for every page.
class PageScroll : public QScrollArea {
    Q_OBJECT

  public:
    explicit PageScroll(PageTabs* pages, QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
};

}  // namespace drillwave
