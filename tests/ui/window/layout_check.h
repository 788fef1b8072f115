// SPDX-License-Identifier: GPL-3.0-or-later
// Faults in the layout of a window that a user would see at a glance.
#pragma once

#include <QStringList>

class QWidget;

namespace drillwave {

/// Returns labels, buttons and fields of a visible window whose text does not fit, or that stick out of their
/// panel.
QStringList clippedTexts(const QWidget& window);

/// Tabs that have no room for their words.
QStringList cutTabs(const QWidget& window);

/// Plots with axes that are too low for numbers and curves, by lines of their text.
QStringList flatPlots(const QWidget& window);

/// Pairs of widgets of one layout that cover each other.
QStringList overlaps(const QWidget& window);

/// Controls that take the focus and have no name for a screen reader.
QStringList namelessControls(const QWidget& window);

/// Returns enabled labels and buttons whose text has less contrast than 4.5 : 1 (WCAG 2.1).
QStringList faintTexts(const QWidget& window);

}  // namespace drillwave
