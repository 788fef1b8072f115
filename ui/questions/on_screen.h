// SPDX-License-Identifier: GPL-3.0-or-later
// Windows where they can be seen.
#pragma once

#include <QSize>

class QWidget;

namespace drillwave {

/// What a window is to be as large as before it is shown, when what the window manager puts about it is not
/// known yet: as wanted, or as its screen has room.
QSize firstSize(const QWidget& window, const QSize& wanted);

/// Moves a window that was placed on a screen which is not there any more, so that its title can be grasped,
/// and makes it no larger than the screen it is on.
void keepOnScreen(QWidget& window);

/// Makes a window no larger than its screen, frame and all, and moves it so that all of it is there.
void fitOnScreen(QWidget& window);

}  // namespace drillwave
