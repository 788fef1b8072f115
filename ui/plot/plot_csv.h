// SPDX-License-Identifier: GPL-3.0-or-later
// The points of the visible curves of a plot as text for other programs.
#pragma once

#include <qcustomplot.h>

#include <QByteArray>
#include <QHash>

#include "ui/plot/curve_meaning.h"

namespace drillwave {

/// Units, names and exact functions of all curves of a plot; the key is the curve.
using CurveMeanings = QHash<const QCPAbstractPlottable*, CurveMeaning>;

/// Returns the points of the visible curves as a table with names and units in the first row. There is one
/// column for x and one for the y of each curve. A curve whose x values differ from those of the curve before
/// it gets its own column for x. Numbers are exact and independent of the locale; shorter columns end with
/// empty cells. The separator ',' gives CSV (RFC 4180, line ends "\n"), a tab gives the form for pasting into
/// spreadsheets.
QByteArray plotCsv(const QCustomPlot& plot, const CurveMeanings& meanings, char separator = ',');

}  // namespace drillwave
