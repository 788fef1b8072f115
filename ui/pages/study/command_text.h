// SPDX-License-Identifier: GPL-3.0-or-later
// The command line that gives the same result as a page of the window.
#pragma once

#include <QString>
#include <QStringList>

#include "ui/document/document.h"

namespace drillwave {

/// Returns the command line for a POSIX shell that runs the study: "drillwave NAME FILE WORDS". A scenario
/// with unsaved changes or without a file is included as a here-document. So the command always studies what
/// the window shows.
QString commandText(const Document& document, const QString& name, const QStringList& words);

/// Returns a word quoted for a POSIX shell if necessary.
QString shellWord(const QString& word);

}  // namespace drillwave
