// SPDX-License-Identifier: GPL-3.0-or-later
// Sampled histories as ready plot data.
#pragma once

#include <QSharedPointer>
#include <QVector>
#include <vector>

#include "ui/text/shown_units.h"

class QCPGraphData;
template <class DataType>
class QCPDataContainer;

namespace drillwave {

/// Shared, never changed once built: handing it to a graph costs nothing however long it is.
using GraphData = QSharedPointer<QCPDataContainer<QCPGraphData>>;

/// Whether curves go on beyond the span of interest, to be panned to, or end there, for formats that do not
/// clip.
enum class Tail { kept, cut };

/// Appends a point if both numbers are finite: one "inf" in the data would make every rescaling of the axes
/// fail without a word.
void appendFinite(QVector<QCPGraphData>& points, double time, double value);

/// Samples in the units they are shown in.
QVector<QCPGraphData> shownPoints(const std::vector<double>& time, const std::vector<double>& value,
                                  const ShownUnit& timeUnit, const ShownUnit& valueUnit);

/// Copies points of not decreasing times.
GraphData graphData(const QVector<QCPGraphData>& points);

/// Returns a history at the bit in shown units: 0 from time 0 to its first point, constant from its last
/// point to `timeEnd`, and with Tail::cut nothing after that.
GraphData historyData(QVector<QCPGraphData> points, double timeEnd, Tail tail);

}  // namespace drillwave
