// SPDX-License-Identifier: GPL-3.0-or-later
// A chapter of the manual laid out for reading.
#pragma once

#include <QPalette>
#include <QTextDocument>

#include "ui/help/manual_book.h"

namespace drillwave {

/// Colours of the manual beside those of a palette.
struct ManualColours {
    QColor link;        ///< legible on the base of the palette
    QColor code;        ///< behind code and headers of tables
    QColor line;        ///< of tables
    QColor mark;        ///< behind what is sought
    QColor markedText;  ///< on that
};
ManualColours manualColours(const QPalette& palette);

/// Fills a document with a chapter, in lines of so many pixels: links where places and names are told, tables
// with lines, code set apart.
void setChapter(QTextDocument& document, const BookChapter& chapter, const ManualBook& book, qreal width,
                const QPalette& palette);

/// The block of a heading or of an equation; the first one where there is none, or nothing is meant.
QTextBlock blockOf(const QTextDocument& document, const QString& heading);

}  // namespace drillwave
