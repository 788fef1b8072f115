// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/help_menu.h"

#include "core/model/version.h"
#include "ui/window/manual_help.h"

namespace drillwave {

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
