// SPDX-License-Identifier: GPL-3.0-or-later
// The menu of languages, in View.
#pragma once

#include <QMenu>

#include "core/text/languages.h"

class QActionGroup;

namespace drillwave {

class Questions;

/// What is chosen counts when the program is started the next time, and is told so.
class LanguageMenu : public QMenu {
    Q_OBJECT

  public:
    /// The questions must outlive the menu.
    LanguageMenu(Questions& questions, QWidget* window);

  private:
    void add(const QString& text, const Language* language);
    void choose(const Language* language);

    Questions& m_questions;
    QWidget* m_window;
    QActionGroup* m_group;
};

}  // namespace drillwave
