// SPDX-License-Identifier: GPL-3.0-or-later
// Links from the widget in use to its place in the manual.
#pragma once

#include <QMainWindow>
#include <QMenu>

#include "ui/help/help_window.h"
#include "ui/questions/questions.h"

class QMenuBar;

namespace drillwave {

class PageTabs;

/// Opens the manual next to the window.
class ManualHelp : public QObject {
    Q_OBJECT

  public:
    /// Window and pages must outlive it.
    ManualHelp(QMainWindow* window, const PageTabs& pages);

    /// Shows the place of the focused field or part, or else of the page on show.
    void showHere();
    void showAt(const ManualPlace& place);
    /// The place that showHere() shows.
    ManualPlace here() const;
    /// The window of the manual; nullptr until it has been opened.
    HelpWindow* helpWindow() const { return m_help; }

  private:
    HelpWindow& help();
    void placeBeside();

    QMainWindow* m_window;
    const PageTabs& m_pages;
    HelpWindow* m_help = nullptr;
};

/// The shortcuts of a menu bar as the rows of a table in Markdown: a section for each menu.
QString shortcutTables(const QMenuBar& menus);

// The Help menu: the manual, its list of keys, and about the program.

class HelpMenu : public QMenu {
    Q_OBJECT

  public:
    /// Manual and questions must outlive the menu.
    HelpMenu(ManualHelp& manual, Questions& questions, QWidget* window);

  private:
    void showAbout();

    Questions& m_questions;
    QWidget* m_window;
};

}  // namespace drillwave
