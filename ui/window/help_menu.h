// SPDX-License-Identifier: GPL-3.0-or-later
// The Help menu: mouse and keys of the plots, and about the program.
#pragma once

#include <QMenu>

#include "ui/questions/questions.h"

namespace drillwave {

class HelpMenu : public QMenu {
    Q_OBJECT

  public:
    /// The questions must outlive the menu.
    HelpMenu(Questions& questions, QWidget* window);

  private:
    void showMouseAndKeys();
    void showAbout();

    Questions& m_questions;
    QWidget* m_window;
};

}  // namespace drillwave
