// SPDX-License-Identifier: GPL-3.0-or-later
// Input fields that the mouse wheel changes only while they have the focus.
#pragma once

class QWidget;

namespace drillwave {

/// Makes a field without focus pass wheel events to its parent widget. The wheel then does not give the field
/// the focus.
void ignoreUnfocusedWheel(QWidget& field);

}  // namespace drillwave
