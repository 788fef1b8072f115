// SPDX-License-Identifier: GPL-3.0-or-later
// Layout of a chapter of the manual as a text document.
#pragma once

#include <QList>
#include <QPalette>
#include <QTextDocument>

#include "ui/help/manual_book.h"

namespace drillwave {

// Links in a text of the manual to other places in it, made from "theory §3", "(T34)", and names of
// parameters, outputs and commands.

/// Part of a line that is a link: first character, number of characters, and target.
struct ManualLink {
    qsizetype begin = 0;
    qsizetype length = 0;
    ManualPlace to;
};

/// Returns the parts of a line of the manual that become links, in order. They are references such as "theory
/// §3" and names of parameters. Only references to existing places become links.
QList<ManualLink> linksIn(const QString& line, const QString& chapter, const ManualBook& book);

/// Returns the place in the manual that describes a word in code font: a parameter, an output, a command or a
/// page. The chapter is empty for other words.
ManualPlace placeOfCode(const QString& code, const ManualBook& book);

/// Colours of the manual that QPalette does not provide.
struct ManualColours {
    QColor link;        ///< text of links, legible on the base colour of the palette
    QColor code;        ///< background of code and of table headers
    QColor line;        ///< lines of tables
    QColor mark;        ///< background of words found by a search
    QColor markedText;  ///< text of words found by a search
};
ManualColours manualColours(const QPalette& palette);

/// Fills a document with a chapter, `width` pixels wide. References to the manual and names of parameters
/// become links, tables get lines, and code is set apart.
void setChapter(QTextDocument& document, const BookChapter& chapter, const ManualBook& book, qreal width,
                const QPalette& palette);

/// Returns the text block of a heading or of an equation, "(12)"; the first block if `heading` is empty or
/// not found.
QTextBlock blockOf(const QTextDocument& document, const QString& heading);

}  // namespace drillwave
