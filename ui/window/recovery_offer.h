// SPDX-License-Identifier: GPL-3.0-or-later
// Offers the unsaved changes of an earlier run that ended unexpectedly.
#pragma once

#include <functional>

#include "ui/document/document.h"
#include "ui/document/recovery.h"
#include "ui/questions/questions.h"

namespace drillwave {

/// Asks about the lost changes in the folder, the last ones first, until some are restored into the document;
/// unanswered ones stay for the next start. Restored changes have the path of their file, whose saved state
/// undo brings back; `takeBeside` takes the work beside the document. Changes that a window left for its
/// successor come back without a question. Files that cannot be used are reported and set aside.
void offerLostChanges(const QString& folder, Document& document, Recovery& recovery, Questions& questions,
                      QWidget* window, const std::function<void(const WorkBeside&)>& takeBeside);

}  // namespace drillwave
