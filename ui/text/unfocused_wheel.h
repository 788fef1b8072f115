// SPDX-License-Identifier: GPL-3.0-or-later
// Input fields that the mouse wheel changes only while they have the focus.
#pragma once

class QWidget;

namespace drillwave {

/// Makes a field without focus pass wheel events to its parent widget, without taking the focus. So scrolling
/// a form with the wheel does not change its values.
void ignoreUnfocusedWheel(QWidget& field);

}  // namespace drillwave
