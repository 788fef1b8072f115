// SPDX-License-Identifier: GPL-3.0-or-later
// The Study menu: the pages of studies, or where their answers are, and what can be done with the one on
// show.
#pragma once

#include <QMenu>

namespace drillwave {

class PageTabs;
class StudyPage;

class StudyMenu : public QMenu {
    Q_OBJECT

  public:
    /// The pages must be there already, and outlive the menu.
    StudyMenu(PageTabs& pages, QWidget* window);

  private:
    StudyPage* current() const;
    void update();

    PageTabs& m_pages;
    QList<std::pair<int, QAction*>> m_choose;  // pages by their index
    QAction* m_copy;
    QAction* m_cancel;
};

}  // namespace drillwave
