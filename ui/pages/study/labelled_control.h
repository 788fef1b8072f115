// SPDX-License-Identifier: GPL-3.0-or-later
// A control with its name before it, as one part of a row.
#pragma once

#include <QWidget>

namespace drillwave {

/// Takes the control; the name is its buddy.
QWidget* labelled(const QString& words, QWidget* control, QWidget* parent);

}  // namespace drillwave
