// SPDX-License-Identifier: GPL-3.0-or-later
// Menu View: units, plots, pages, areas and their layout.
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

// Submenu of languages in the menu View.

/// Menu in which the user chooses the language of the window. A choice takes effect in the next window; a
/// restart is offered.
class LanguageMenu : public QMenu {
    Q_OBJECT

  public:
    /// Creates the menu. `questions`, which asks the user in dialogs, must outlive it.
    LanguageMenu(Questions& questions, QWidget* window);

  signals:
    /// Emitted when the user wants to restart the window in the chosen language.
    void restartWanted();

  private:
    void add(const QString& text, const Language* language);
    void choose(const Language* language);

    Questions& m_questions;
    QWidget* m_window;
    QActionGroup* m_group;
};

// Menu of the visible plot, with all entries of the plot's context menu.

class PlotViewMenu : public QMenu {
    Q_OBJECT

  public:
    /// Creates the menu of the visible plot. The pages must outlive it.
    PlotViewMenu(PageTabs& pages, QWidget* window);

    /// Returns the action that shows and hides the tables of readings below all plots. The choice is stored
    /// in the user settings.
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
    /// Parts of the window on which the entries of the menu act. All must outlive the menu.
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
    /// Emitted when the user wants to restart the window in another language.
    void restartWanted();
};

}  // namespace drillwave
