// SPDX-License-Identifier: GPL-3.0-or-later
// Folders suggested for exports, and the mouse pointer during drawing.
#pragma once

#include <QString>

#include "ui/document/document.h"

namespace drillwave {

/// Returns a path to suggest for an export, in the folder of the last export or else of the scenario. The
/// name is that of the scenario with `ending`, such as "_report.html".
QString exportSuggestion(const Document& document, const QString& ending);

/// Stores the folder that the next export suggests: the folder of `path`, or `path` if it is a folder.
void rememberExportFolder(const QString& path);

/// Wait cursor, shown for the lifetime of an object, for example while a picture is drawn.
class WaitCursor {
  public:
    WaitCursor();
    ~WaitCursor();
    WaitCursor(const WaitCursor&) = delete;
    WaitCursor& operator=(const WaitCursor&) = delete;
};

}  // namespace drillwave
