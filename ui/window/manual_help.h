// SPDX-License-Identifier: GPL-3.0-or-later
// Help on the widget in use: opens its place in the manual.
#pragma once

#include <QMainWindow>
#include <QMenu>

#include "ui/help/help_window.h"
#include "ui/questions/questions.h"

class QMenuBar;

namespace drillwave {

class PageTabs;

/// Object that opens the manual in a window beside the main window.
class ManualHelp : public QObject {
    Q_OBJECT

  public:
    /// Makes the help without opening the manual. Window and pages must outlive it.
    ManualHelp(QMainWindow* window, const PageTabs& pages);

    /// Shows the place in the manual that describes the focused field or area, or else the visible page.
    void showHere();
    void showAt(const ManualPlace& place);
    /// Returns the place in the manual that showHere() shows.
    ManualPlace here() const;
    /// Returns the window of the manual; nullptr until it has been opened.
    HelpWindow* helpWindow() const { return m_help; }

  private:
    HelpWindow& help();
    void placeBeside();

    QMainWindow* m_window;
    const PageTabs& m_pages;
    HelpWindow* m_help = nullptr;
};

/// Returns the keyboard shortcuts of a menu bar as Markdown: a section with a table for each menu.
QString shortcutTables(const QMenuBar& menus);

// Menu Help: the manual, the list of shortcuts, and information about the program.

class HelpMenu : public QMenu {
    Q_OBJECT

  public:
    /// Makes the menu. Manual and questions must outlive it.
    HelpMenu(ManualHelp& manual, Questions& questions, QWidget* window);

  private:
    void showAbout();

    Questions& m_questions;
    QWidget* m_window;
};

}  // namespace drillwave
