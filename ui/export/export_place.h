// SPDX-License-Identifier: GPL-3.0-or-later
// Places for exports, and the pointer while they are drawn.
#pragma once

#include <QString>

#include "ui/document/document.h"

namespace drillwave {

/// Returns a path in the folder of the last export, or else of the scenario: its name with another ending.
QString exportSuggestion(const Document& document, const QString& ending);

/// The folder of a file that was written, or the folder itself.
void rememberExportFolder(const QString& path);

/// While a picture is drawn the window waits.
class WaitCursor {
  public:
    WaitCursor();
    ~WaitCursor();
    WaitCursor(const WaitCursor&) = delete;
    WaitCursor& operator=(const WaitCursor&) = delete;
};

}  // namespace drillwave
