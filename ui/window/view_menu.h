// SPDX-License-Identifier: GPL-3.0-or-later
// The View menu: units, plots, pages, areas and their layout.
#pragma once

#include <QMenu>

namespace drillwave {

class AreaKeys;
class ExampleNote;
class PageTabs;
class Questions;
class UnitsChoice;
class WindowLayout;

class ViewMenu : public QMenu {
    Q_OBJECT

  public:
    /// What the menu is about, all of which must outlive it.
    struct Parts {
        UnitsChoice& units;
        PageTabs& pages;
        AreaKeys& areas;
        WindowLayout& layout;
        ExampleNote& example;
        Questions& questions;
    };
    ViewMenu(const Parts& parts, QWidget* window);

  signals:
    /// The user wants the window in another language now.
    void restartWanted();
};

}  // namespace drillwave
