// SPDX-License-Identifier: GPL-3.0-or-later
// A chapter of the manual laid out for reading.
#pragma once

#include <QList>
#include <QPalette>
#include <QTextDocument>

#include "ui/help/manual_book.h"

namespace drillwave {

// Links in a text of the manual to other places in it: "theory §3", "(T34)", names of parameters, outputs and
// commands.

/// A stretch of a line that is a link.
struct ManualLink {
    qsizetype begin = 0;
    qsizetype length = 0;
    ManualPlace to;
};

/// Returns the links in a line of a chapter, in order, whose place exists.
QList<ManualLink> linksIn(const QString& line, const QString& chapter, const ManualBook& book);

/// Returns the place of a piece of code that names a parameter, an output, a command or a page; no chapter
/// for other code.
ManualPlace placeOfCode(const QString& code, const ManualBook& book);

/// Colours of the manual beside those of a palette.
struct ManualColours {
    QColor link;        ///< legible on the base of the palette
    QColor code;        ///< of the background of code and headers of tables
    QColor line;        ///< of tables
    QColor mark;        ///< of the background of words found
    QColor markedText;  ///< on that
};
ManualColours manualColours(const QPalette& palette);

/// Fills a document with a chapter, `width` pixels wide: places and names as links, tables with lines, code
// set apart.
void setChapter(QTextDocument& document, const BookChapter& chapter, const ManualBook& book, qreal width,
                const QPalette& palette);

/// Returns the block of a heading or of an equation, "(12)"; the first block if `heading` is empty or not
/// found.
QTextBlock blockOf(const QTextDocument& document, const QString& heading);

}  // namespace drillwave
