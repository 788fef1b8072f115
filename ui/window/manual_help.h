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

/// Opener of the manual, which is shown in a window beside the main window.
class ManualHelp : public QObject {
    Q_OBJECT

  public:
    /// Creates the help. The manual is opened only when it is needed. Window and pages must outlive this
    /// object.
    ManualHelp(QMainWindow* window, const PageTabs& pages);

    /// Opens the manual at the place that describes the focused input field or area, or else the visible
    /// page.
    void showHere();
    void showAt(const ManualPlace& place);
    /// Returns the place in the manual that showHere() opens: that of the focused field or area, or else of
    /// the visible page.
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
    /// Creates the menu. `manual`, which opens the manual, and `questions`, which shows dialogs, must outlive
    /// it.
    HelpMenu(ManualHelp& manual, Questions& questions, QWidget* window);

  private:
    void showAbout();

    Questions& m_questions;
    QWidget* m_window;
};

}  // namespace drillwave
