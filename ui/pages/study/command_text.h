// SPDX-License-Identifier: GPL-3.0-or-later
// The command line that does what a page of the window does.
#pragma once

#include <QString>
#include <QStringList>

#include "ui/document/document.h"

namespace drillwave {

/// The command for a POSIX shell: "drillwave NAME FILE WORDS". A scenario that no file holds as it is goes
/// along as a here-document, so that the command always studies what the window shows.
QString commandText(const Document& document, const QString& name, const QStringList& words);

/// A word as a shell takes it whole: quoted where it needs to be.
QString shellWord(const QString& word);

}  // namespace drillwave
