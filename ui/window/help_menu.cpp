// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/help_menu.h"

#include "core/model/version.h"

namespace drillwave {

HelpMenu::HelpMenu(Questions& questions, QWidget* window)
    : QMenu(tr("&Help"), window), m_questions(questions), m_window(window) {
    addAction(tr("&Mouse and keys"), QKeySequence(Qt::Key_F1), this, &HelpMenu::showMouseAndKeys);
    addAction(tr("&About Drillwave"), this, &HelpMenu::showAbout);
}

void HelpMenu::showMouseAndKeys() {
    m_questions.tell(
        m_window, Questions::Tone::information, tr("Mouse and keys"),
        tr("Window\n"
           "Ctrl+Tab, Ctrl+Shift+Tab: next page, previous page; F6, Shift+F6: scenario, page, result\n"
           "Ctrl+I, Ctrl+U, Ctrl+L: SI, US units, dimensionless\n"
           "F7: pin the result, to compare others with\n"
           "Ctrl+R, Ctrl+P: write, print the report; Ctrl+Shift+P, Ctrl+Shift+C: save, copy the picture\n"
           "\n"
           "Plots\n"
           "Wheel: zoom at the pointer; over an axis, that axis only\n"
           "Drag: move; Shift+drag or right button: zoom to a box\n"
           "Double-click or Home: fit; Backspace or Alt+Left: zoom back\n"
           "Click on a legend entry: hide or show the curve\n"
           "A, B: cursors at the pointer, on the curve there; T: time cursor; Ctrl+Left, Ctrl+Right: move "
           "the last one\n"
           "Arrows: move; + and −: zoom; right click or Shift+F10: menu\n"
           "Studies: a click takes over the point there, with Shift it pins it\n"
           "Studies and Rod: Enter puts a point into the plot, which keys move, and Enter again is a click "
           "there, Shift+Enter one with Shift\n"
           "Left, Right: along the curve; Up, Down: to the next curve; Shift+arrows: ten times as far; Home, "
           "End: to its ends; N, Shift+N: to the next mark, the one before; Esc: away with the point\n"
           "\n"
           "Wave picture\n"
           "Drag the dashed line (section) and the solid line (time), or Ctrl+arrows; Space: play\n"
           "\n"
           "Import of measured signals\n"
           "Ctrl+Shift+I, or “Measured…” beside the shape of the blow; F1 there explains its steps\n"
           "\n"
           "Rod\n"
           "Click on a peak or a curve: section and time at which the stress is that large\n"
           "\n"
           "Fields\n"
           "Type a number with any unit: 38 mm, 1.5 in; Up, Down or the wheel: step; Alt+Down: unit\n"
           "Arithmetic: 2*3.05 m, 12 ft + 3 in, 12' 6\", 1/2 in\n"
           "Sliders: a click in the groove jumps there; Shift+drag: ten times finer; double-click: the "
           "file's value"));
}

void HelpMenu::showAbout() {
    m_questions.tell(m_window, Questions::Tone::information,
                     tr("Drillwave %1").arg(QLatin1String(versionText)),
                     tr("Percussive rock drilling: waves in the rod, the impact on the rock, the rebound.\n"
                        "Free software under the GNU General Public License, version 3 or later."));
}

}  // namespace drillwave
