// SPDX-License-Identifier: GPL-3.0-or-later
// What an import gives, in sentences.
#pragma once

#include <QString>

#include "ui/import/import_preview.h"

namespace drillwave {

class UnitChoice;

/// Samples, impulse, peak, points and how far they are from the samples; what was skipped and clipped.
/// Requires a preview without problems.
QString importSummary(const ImportPreview& preview, const UnitChoice& units);

/// How to import, for F1.
QString importHelp();

}  // namespace drillwave
