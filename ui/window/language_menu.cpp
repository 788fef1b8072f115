// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/language_menu.h"

#include <QActionGroup>

#include "ui/questions/questions.h"
#include "ui/text/language.h"
#include "ui/text/shown_text.h"

namespace drillwave {

LanguageMenu::LanguageMenu(Questions& questions, QWidget* window)
    : QMenu(tr("&Language"), window),
      m_questions(questions),
      m_window(window),
      m_group(new QActionGroup(this)) {
    setObjectName(QStringLiteral("language"));
    add(tr("&System"), nullptr);
    addSeparator();
    for (const Language& language : languages) add(fromView(language.name), &language);
}

void LanguageMenu::add(const QString& text, const Language* language) {
    QAction* action = m_group->addAction(text);
    action->setCheckable(true);
    action->setChecked(language == chosenLanguage());
    connect(action, &QAction::triggered, this, [this, language] { choose(language); });
    addAction(action);
}

void LanguageMenu::choose(const Language* language) {
    if (language == chosenLanguage()) return;
    chooseLanguage(language);
    const QString name = fromView(languageToSpeak().name);
    if (m_questions.restartNow(
            m_window, tr("Restart Drillwave in this language now: %1?").arg(name),
            tr("Unsaved changes, the file name, pinned runs and measured signals come back. Numbers stay as "
               "the "
               "system writes them; files and some chapters of the manual are in English.")))
        emit restartWanted();
}

}  // namespace drillwave
