// SPDX-License-Identifier: GPL-3.0-or-later
// Readings of a curve, as the cells of a small table.
#pragma once

#include <QList>
#include <QLocale>
#include <QString>

#include "ui/plot/curve_meaning.h"
#include "ui/plot/curve_reading.h"
#include "ui/plot/view_statistics.h"

namespace drillwave {

/// One number with its unit. NaN if it is not known.
struct ReadingCell {
    QString name;   ///< in full, for what is copied or read aloud: "F at A"
    QString label;  ///< before the number in the table; may be empty
    double value = 0;
    QString unit = {};
    QString words = {};  ///< instead of the number, on an axis of words

    /// "1.2 ms", "–" where it is not known.
    QString text(const QLocale& locale, int digits) const;
};

/// Three columns of two cells, x above y, and three more; a cell without a name stays empty.
inline constexpr qsizetype readingCellCount = 9;
using ReadingCells = QList<ReadingCell>;

/// Places and values at the cursors, their differences, mean, slope and integral. The meaning has both names.
ReadingCells cursorCells(const CursorReading& reading, const CurveMeaning& meaning);

/// Least and largest value with their places in the view, mean and integral. The meaning has both names.
ReadingCells viewCells(const ViewStatistics& statistics, const CurveMeaning& meaning);

/// Digits of a number where there is room for it.
inline constexpr int readingDigits = 6;

/// All cells in one line: "A 1.2 ms · F at A 10 kN · …".
QString readingText(const ReadingCells& cells, const QLocale& locale);

/// Lines of name, number and unit with tabs between them, for a spreadsheet; numbers as in files.
QString readingTable(const QString& curve, const ReadingCells& cells);

}  // namespace drillwave
