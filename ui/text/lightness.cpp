// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/lightness.h"

#include <QApplication>
#include <QLabel>

namespace drillwave {

void setWarning(QLabel& label, bool warning) {
    QFont font = label.font();
    font.setBold(warning);
    label.setFont(font);
    QPalette palette;  // all of it follows the application
    if (warning) {
        const QPalette shown = QApplication::palette(&label);
        // Contrast of 4.5 at least, on windows light and dark.
        const bool dark = isDark(shown.color(QPalette::Window));
        for (const auto group : {QPalette::Active, QPalette::Inactive})
            palette.setColor(group, QPalette::WindowText,
                             dark ? QColor(0xff, 0x9e, 0x8a) : QColor(0xa8, 0x1e, 0x0c));
    }
    label.setPalette(palette);
}

}  // namespace drillwave
