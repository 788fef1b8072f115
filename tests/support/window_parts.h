// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a window by their type: part<ExportMenu>(window).
#pragma once

#include "ui/pages/study/figure_page.h"
#include "ui/window/main_window.h"

namespace drillwave {

template <class Part>
Part& part(const MainWindow& window) {
    auto* found = window.findChild<Part*>();
    if (!found) qFatal("the window has no %s", Part::staticMetaObject.className());
    return *found;
}

/// The page of a study that is a value, by the name of the study.
inline FigurePage& studyPage(const MainWindow& window, const char* study) {
    auto* found = window.findChild<FigurePage*>(QLatin1String(study));
    if (!found) qFatal("the window has no page of %s", study);
    return *found;
}

}  // namespace drillwave
