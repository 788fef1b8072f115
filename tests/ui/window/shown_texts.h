// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of a window: on its controls, in menus, tables and plots, and for assistive tools.
#pragma once

#include <QStringList>

class QWidget;

namespace drillwave {

struct ShownText {
    QString where;  ///< "QLabel “cor” of QWidget, tool tip"
    QString text;   ///< plain, without marks of rich text
};

QList<ShownText> shownTexts(QWidget& window);

}  // namespace drillwave
