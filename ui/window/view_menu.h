// SPDX-License-Identifier: GPL-3.0-or-later
// The View menu: units, plots, pages, areas and their layout.
#pragma once

#include <QMenu>

#include "core/text/languages.h"

class QActionGroup;

namespace drillwave {

class AreaKeys;
class ExampleNote;
class PageTabs;
class PlotWidget;
class Questions;
class UnitsChoice;
class WindowLayout;

// The menu of languages, in View.

/// The choice takes effect in the next window; a restart is offered.
class LanguageMenu : public QMenu {
    Q_OBJECT

  public:
    /// The questions must outlive the menu.
    LanguageMenu(Questions& questions, QWidget* window);

  signals:
    /// The user wants the window in the chosen language now.
    void restartWanted();

  private:
    void add(const QString& text, const Language* language);
    void choose(const Language* language);

    Questions& m_questions;
    QWidget* m_window;
    QActionGroup* m_group;
};

// The menu of the plot on show: all that its context menu has, in the menu bar.

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

class ViewMenu : public QMenu {
    Q_OBJECT

  public:
    /// Parts of the window in the menu, all of which must outlive it.
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
