// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/study_menu.h"

#include "ui/pages/study/study_page.h"
#include "ui/window/page_tabs.h"

namespace drillwave {

StudyMenu::StudyMenu(PageTabs& pages, QWidget* window) : QMenu(tr("&Study"), window), m_pages(pages) {
    for (int index = 0; index < pages.count(); ++index)
        if (qobject_cast<StudyPage*>(&pages.page(index)))
            m_choose.append({index, addAction(pages.page(index).title(), this,
                                              [&pages, index] { pages.choose(index); })});
    addSeparator();
    m_copy = addAction(tr("&Copy as command line"), this, [this] {
        if (StudyPage* page = current()) page->copyCommand();
    });
    m_cancel = addAction(tr("C&ancel"), this, [this] {
        if (StudyPage* page = current()) page->activity()->cancel();
    });
    connect(this, &QMenu::aboutToShow, this, &StudyMenu::update);
    connect(&pages, &QStackedWidget::currentChanged, this, &StudyMenu::update);
    connect(&pages, &PageTabs::offersChanged, this, &StudyMenu::update);
    update();
}

StudyPage* StudyMenu::current() const {
    return qobject_cast<StudyPage*>(m_pages.currentWidget());
}

void StudyMenu::update() {
    const StudyPage* page = current();
    m_copy->setEnabled(page);
    for (const auto& [index, action] : std::as_const(m_choose))
        action->setText(m_pages.page(index).title());  // another one for strings
    m_cancel->setEnabled(page && page->activity()->state() == StudyState::running);
}

}  // namespace drillwave
