// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/manual_help.h"

#include <QApplication>
#include <QMenu>
#include <QMenuBar>
#include <QScreen>
#include <algorithm>

#include "core/model/version.h"
#include "ui/help/help_topic.h"
#include "ui/questions/on_screen.h"
#include "ui/text/language.h"
#include "ui/window/page_tabs.h"

namespace drillwave {

namespace {

constexpr int leastBeside = 640;  // [px] narrower, a page of the manual is not read with ease

// The actions of a menu and of those that open from it.
void addRows(const QMenu& menu, QStringList& rows) {
    for (const QAction* action : menu.actions()) {
        if (const QMenu* below = action->menu()) addRows(*below, rows);
        if (action->shortcut().isEmpty()) continue;
        QStringList keys;
        for (const QKeySequence& each : action->shortcuts())
            keys.append(each.toString(QKeySequence::NativeText));
        QString text = action->text().remove(u'&');
        rows.append(
            QStringLiteral("| %1 | %2 |").arg(keys.join(QStringLiteral(", ")), text.replace(u'|', u'/')));
    }
}

}  // namespace

QString shortcutTables(const QMenuBar& menus) {
    QString text = QStringLiteral("## %1\n").arg(ManualHelp::tr("Menus and their keys"));
    for (const QAction* action : menus.actions()) {
        QStringList rows;
        if (action->menu()) addRows(*action->menu(), rows);
        if (rows.isEmpty()) continue;
        text += QStringLiteral("\n### %1\n\n| %2 | %3 |\n|---|---|\n%4\n")
                    .arg(action->text().remove(u'&'), ManualHelp::tr("key"), ManualHelp::tr("action"),
                         rows.join(u'\n'));
    }
    return text;
}

ManualHelp::ManualHelp(QMainWindow* window, const PageTabs& pages)
    : QObject(window), m_window(window), m_pages(pages) {}

ManualPlace ManualHelp::here() const {
    const ManualPlace place = topicOf(m_window->focusWidget());
    if (!place.chapter.isEmpty()) return place;
    // "Compare (2)"
    return {QStringLiteral("window"), m_pages.current().title().section(QStringLiteral(" ("), 0, 0)};
}

void ManualHelp::showHere() {
    showAt(here());
}

void ManualHelp::showAt(const ManualPlace& place) {
    const bool isNew = !m_help;
    HelpWindow& window = help();
    if (isNew) placeBeside();
    window.open(place);
}

HelpWindow& ManualHelp::help() {
    if (m_help) return *m_help;
    ManualBook book(spokenLanguage());
    book.append(QStringLiteral("keys"), shortcutTables(*m_window->menuBar()));
    m_help = new HelpWindow(std::move(book), m_window);
    return *m_help;
}

// Where there is room, to the right of the window, else to its left, else at the right edge of the screen.
void ManualHelp::placeBeside() {
    if (m_help->restorePlace()) return keepOnScreen(*m_help);
    const QRect room = m_window->screen()->availableGeometry(), frame = m_window->frameGeometry();
    const int right = room.right() - frame.right(), left = frame.left() - room.left();
    const int width = std::min(m_help->width(), std::max({right, left, leastBeside}));
    m_help->resize(firstSize(*m_help, {width, std::max(m_help->height(), frame.height())}));
    const int height = m_help->height();
    const int x = right >= leastBeside  ? frame.right() + 1
                  : left >= leastBeside ? frame.left() - width
                                        : room.right() + 1 - width;
    m_help->move(x, std::clamp(frame.top(), room.top(), room.bottom() + 1 - height));
}

HelpMenu::HelpMenu(ManualHelp& manual, Questions& questions, QWidget* window)
    : QMenu(tr("&Help"), window), m_questions(questions), m_window(window) {
    addAction(tr("&Manual"), QKeySequence(Qt::Key_F1), &manual, &ManualHelp::showHere);
    const auto open = [&manual](const char* chapter) {
        return [&manual, chapter] { manual.showAt({QLatin1String(chapter)}); };
    };
    addAction(tr("&Tutorial"), &manual, open("tutorial"));
    addAction(tr("Mouse and &keys"), &manual, open("keys"));
    addAction(tr("&Glossary"), &manual, open("glossary"));
    addSeparator();
    addAction(tr("&About Drillwave"), this, &HelpMenu::showAbout);
}

void HelpMenu::showAbout() {
    m_questions.tell(m_window, Questions::Tone::information,
                     tr("Drillwave %1").arg(QLatin1String(versionText)),
                     tr("Percussive rock drilling: waves in the rod, the impact on the rock, the rebound.\n"
                        "Free software under the GNU General Public License, version 3 or later."));
}

}  // namespace drillwave
