// SPDX-License-Identifier: GPL-3.0-or-later
// The points of the visible curves of a plot as text for other programs.
#pragma once

#include <qcustomplot.h>

#include <QByteArray>
#include <QHash>

#include "ui/plot/curve_meaning.h"

namespace drillwave {

using CurveMeanings = QHash<const QCPAbstractPlottable*, CurveMeaning>;

/// Returns one column for x and one for each curve, named with their units; curves on other x have a column
/// for them in front. Numbers read back exactly, whatever the locale. Shorter columns end with empty cells. A
/// separator of ',' gives CSV after RFC 4180 with line ends "\n", a tab the form that spreadsheets take from
/// the clipboard.
QByteArray plotCsv(const QCustomPlot& plot, const CurveMeanings& meanings, char separator = ',');

}  // namespace drillwave
