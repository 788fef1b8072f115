// SPDX-License-Identifier: GPL-3.0-or-later
// A control with its label before it.
#pragma once

#include <QWidget>

namespace drillwave {

/// Returns a widget with a label and a control. It takes ownership of the control, which becomes the buddy of
/// the label.
QWidget* labelled(const QString& words, QWidget* control, QWidget* parent);

}  // namespace drillwave
