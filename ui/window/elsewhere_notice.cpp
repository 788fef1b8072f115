// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/elsewhere_notice.h"

#include <QPushButton>

#include "ui/window/page_tabs.h"

namespace drillwave {

ElsewhereNotice::ElsewhereNotice(PageTabs& pages, QWidget* parent)
    : Notice(Tone::information, parent),
      m_show(addButton(tr("Go there"), tr("To the page that has the answer"))) {
    setObjectName(QStringLiteral("elsewhere"));
    m_show->setObjectName(QStringLiteral("goThere"));
    connect(m_show, &QPushButton::clicked, this, [this] {
        if (m_page) emit m_page->elsewhereRequested();
    });
    connect(&pages, &PageTabs::absent, this, &ElsewhereNotice::tell);
    connect(&pages, &QStackedWidget::currentChanged, this, &QWidget::hide);
    connect(&pages, &PageTabs::offersChanged, this, [this, &pages] {
        if (m_page && pages.isOffered(pages.indexOf(m_page))) hide();
    });
}

void ElsewhereNotice::tell(Page* page) {
    m_page = page;
    m_show->setVisible(page->leadsElsewhere());
    say(page->elsewhere());
}

}  // namespace drillwave
