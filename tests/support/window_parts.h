// SPDX-License-Identifier: GPL-3.0-or-later
// Access to the parts of a window by their type: part<ExportMenu>(window).
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

/// Returns the page of a study by the study's name; ends the test if there is none.
inline FigurePage& studyPage(const MainWindow& window, const char* study) {
    auto* found = window.findChild<FigurePage*>(QLatin1String(study));
    if (!found) qFatal("the window has no page of %s", study);
    return *found;
}

}  // namespace drillwave
