// SPDX-License-Identifier: GPL-3.0-or-later
// Menu Study: the pages of studies, and actions for the visible study.
#pragma once

#include <QMenu>

namespace drillwave {

class PageTabs;
class StudyPage;

class StudyMenu : public QMenu {
    Q_OBJECT

  public:
    /// Creates the menu of the studies. All pages must already have been added, and must outlive the menu.
    StudyMenu(PageTabs& pages, QWidget* window);

  private:
    StudyPage* current() const;
    void update();

    PageTabs& m_pages;
    QList<std::pair<int, QAction*>> m_choose;  // actions that show a page, with the page's index
    QAction* m_copy;
    QAction* m_cancel;
};

}  // namespace drillwave
