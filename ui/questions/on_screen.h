// SPDX-License-Identifier: GPL-3.0-or-later
// Windows where they can be seen.
#pragma once

#include <QSize>

class QWidget;

namespace drillwave {

/// Returns the size for a window that is not shown yet and whose frame is not known: as wanted, but no larger
/// than its screen has room for.
QSize firstSize(const QWidget& window, const QSize& wanted);

/// Moves a window that was placed on a screen which is not there any more, so that its title can be grasped,
/// and makes it no larger than the screen it is on.
void keepOnScreen(QWidget& window);

/// Makes a window no larger than its screen, frame and all, and moves it so that all of it is there.
void fitOnScreen(QWidget& window);

}  // namespace drillwave
