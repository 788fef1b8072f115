// SPDX-License-Identifier: GPL-3.0-or-later
// The Help menu: the manual, its list of keys, and about the program.
#pragma once

#include <QMenu>

#include "ui/questions/questions.h"

namespace drillwave {

class ManualHelp;

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
