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

/// Cell of the table of readings below a plot: a number with its name and unit. A value of NaN means that it
/// is not known.
struct ReadingCell {
    /// Full name, used for copying and for screen readers, such as "F at A". An empty name means an empty
    /// cell.
    QString name;
    QString label;  ///< short name before the number in the table; may be empty
    double value = 0;
    QString unit = {};
    QString words = {};  ///< word shown instead of the number, if the axis has words

    /// Returns the content of the cell as shown, such as "1.2 ms", or "–" if the value is not known. `digits`
    /// is the number of significant digits.
    QString text(const QLocale& locale, int digits) const;
};

/// Number of cells of the table of readings: three columns of two cells (x above y), and three further cells.
/// A cell without a name stays empty.
inline constexpr qsizetype readingCellCount = 9;
using ReadingCells = QList<ReadingCell>;

/// Returns the cells of the table below the plot for the cursors A and B: x and y at A and B, their
/// differences, mean, slope and integral. `meaning` must contain the names of x and y.
ReadingCells cursorCells(const CursorReading& reading, const CurveMeaning& meaning);

/// Returns the cells of the table below the plot for the part of the curve in view: smallest and largest y
/// with their x, ends of the part, mean and integral. `meaning` must contain the names of x and y.
ReadingCells viewCells(const ViewStatistics& statistics, const CurveMeaning& meaning);

/// Significant digits of a number in the table of readings below a plot, if there is enough space.
inline constexpr int readingDigits = 6;

/// Returns all cells in one line: "A 1.2 ms · F at A 10 kN · …".
QString readingText(const ReadingCells& cells, const QLocale& locale);

/// Returns a table for a spreadsheet: the name of the curve, then lines of name, number and unit separated by
/// tabs. Numbers have all digits and a decimal point.
QString readingTable(const QString& curve, const ReadingCells& cells);

}  // namespace drillwave
