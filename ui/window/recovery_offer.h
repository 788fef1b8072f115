// SPDX-License-Identifier: GPL-3.0-or-later
// Offer to restore unsaved changes of an earlier session that ended unexpectedly.
#pragma once

#include <functional>

#include "ui/document/document.h"
#include "ui/document/recovery.h"
#include "ui/questions/questions.h"

namespace drillwave {

/// Asks the user, for each recovery file in the folder (latest first), whether to restore its unsaved
/// changes. Stops when one is restored into the document; the others are offered at the next start. Undo then
/// leads back to the saved file. `takeBeside` receives the restored runs and signals. Changes left by a
/// restarted window are restored without asking. Unusable files are reported and renamed.
void offerLostChanges(const QString& folder, Document& document, Recovery& recovery, Questions& questions,
                      QWidget* window, const std::function<void(const WorkBeside&)>& takeBeside);

}  // namespace drillwave
