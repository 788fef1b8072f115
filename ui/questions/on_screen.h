// SPDX-License-Identifier: GPL-3.0-or-later
// Size and position of windows on the screen.
#pragma once

#include <QSize>

class QWidget;

namespace drillwave {

/// Returns the initial size of a window that is not shown yet. It is `wanted`, but no larger than the screen
/// minus the edges of a typical window frame.
QSize firstSize(const QWidget& window, const QSize& wanted);

/// Moves a window that lies outside all screens so that its title can be reached, and makes it no larger than
/// its screen.
void keepOnScreen(QWidget& window);

/// Makes a window, including its frame, no larger than its screen, and moves it completely onto the screen.
void fitOnScreen(QWidget& window);

}  // namespace drillwave
