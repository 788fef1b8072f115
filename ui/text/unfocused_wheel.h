// SPDX-License-Identifier: GPL-3.0-or-later
// Fields that the mouse wheel changes only while they have the focus.
#pragma once

class QWidget;

namespace drillwave {

/// Leaves the wheel over a field without focus to its parent widget. The wheel gives the field no
/// focus.
void ignoreUnfocusedWheel(QWidget& field);

}  // namespace drillwave
