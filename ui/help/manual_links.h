// SPDX-License-Identifier: GPL-3.0-or-later
// What in a text of the manual leads to another place of it: "theory §3", "(T34)", names of parameters,
// outputs and commands.
#pragma once

#include <QList>

#include "ui/help/manual_book.h"

namespace drillwave {

/// A stretch of a line that is a link.
struct ManualLink {
    qsizetype begin = 0;
    qsizetype length = 0;
    ManualPlace to;
};

/// Those in a line of a chapter, in order, that lead to a place which is there.
QList<ManualLink> linksIn(const QString& line, const QString& chapter, const ManualBook& book);

/// Where a piece of code leads that names a parameter, an output, a command or a page; no chapter where it
/// names none.
ManualPlace placeOfCode(const QString& code, const ManualBook& book);

}  // namespace drillwave
