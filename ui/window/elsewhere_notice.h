// SPDX-License-Identifier: GPL-3.0-or-later
// Says why a page that is wanted is not there for this scenario, and where its answer is.
#pragma once

#include <QPointer>

#include "ui/window/notice.h"

namespace drillwave {

class Page;
class PageTabs;

/// Goes away with the next page on show, and when its page is there again.
class ElsewhereNotice : public Notice {
    Q_OBJECT

  public:
    /// The pages must outlive it.
    explicit ElsewhereNotice(PageTabs& pages, QWidget* parent = nullptr);

  private:
    void tell(Page* page);

    QPushButton* m_show;  // there where the page leads to the answer
    QPointer<Page> m_page;
};

}  // namespace drillwave
