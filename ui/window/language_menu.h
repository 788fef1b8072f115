// SPDX-License-Identifier: GPL-3.0-or-later
// The menu of languages, in View.
#pragma once

#include <QMenu>

#include "core/text/languages.h"

class QActionGroup;

namespace drillwave {

class Questions;

/// What is chosen counts for the next window; a restart is offered.
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

}  // namespace drillwave
