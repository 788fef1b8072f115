// SPDX-License-Identifier: GPL-3.0-or-later
// Faults in the layout of a window that a user would see at a glance.
#pragma once

#include <QStringList>

class QWidget;

namespace drillwave {

/// Labels, buttons and fields of a visible window whose text does not fit where it stands, or that stick out
/// of the panel they are in.
QStringList clippedTexts(const QWidget& window);

/// Tabs that have no room for their words.
QStringList cutTabs(const QWidget& window);

/// Plots with axes that are too low for numbers and curves, by lines of their text.
QStringList flatPlots(const QWidget& window);

/// Pairs of widgets of one layout that cover each other.
QStringList overlaps(const QWidget& window);

/// Controls that take the focus and have no name for a screen reader.
QStringList namelessControls(const QWidget& window);

/// Enabled labels and buttons whose text stands out from what is behind it by less than 4.5 : 1 (WCAG 2.1).
QStringList faintTexts(const QWidget& window);

}  // namespace drillwave
