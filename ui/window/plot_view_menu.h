// SPDX-License-Identifier: GPL-3.0-or-later
// The menu of the plot on show: all that its context menu has, in the menu bar.
#pragma once

#include <QMenu>

namespace drillwave {

class PageTabs;
class PlotWidget;

class PlotViewMenu : public QMenu {
    Q_OBJECT

  public:
    /// The pages must outlive the menu.
    PlotViewMenu(PageTabs& pages, QWidget* window);

    /// Shows and hides the tables below all plots; kept in the settings.
    QAction* tableAction() const { return m_table; }

  private:
    PlotWidget* plot() const;
    void fill();

    PageTabs& m_pages;
    QAction* m_table;
};

}  // namespace drillwave
