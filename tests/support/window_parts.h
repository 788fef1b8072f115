// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a window by their type: part<ExportMenu>(window).
#pragma once

#include "ui/window/main_window.h"

namespace drillwave {

template <class Part>
Part& part(const MainWindow& window) {
    auto* found = window.findChild<Part*>();
    if (!found) qFatal("the window has no %s", Part::staticMetaObject.className());
    return *found;
}

}  // namespace drillwave
