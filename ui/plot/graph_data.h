// SPDX-License-Identifier: GPL-3.0-or-later
// Time histories converted to the data of plot curves.
#pragma once

#include <QSharedPointer>
#include <QVector>
#include <vector>

#include "ui/text/shown_units.h"

class QCPGraphData;
template <class DataType>
class QCPDataContainer;

namespace drillwave {

/// Points of a graph. They are shared and never changed once built, so that passing them to a graph copies
/// nothing.
using GraphData = QSharedPointer<QCPDataContainer<QCPGraphData>>;

/// Treatment of the part of a time history after the end of the default plot range. `kept` keeps its points,
/// which the user can see by panning; `cut` removes them, for file formats that do not clip.
enum class Tail { kept, cut };

/// Appends a point if time and value are finite. One infinite number in the data would make every rescaling
/// of the axes fail silently.
void appendFinite(QVector<QCPGraphData>& points, double time, double value);

/// Returns the samples of a time history as points of a graph: time and value, each multiplied by the factor
/// of its unit. Samples that are not finite are left out.
QVector<QCPGraphData> shownPoints(const std::vector<double>& time, const std::vector<double>& value,
                                  const ShownUnit& timeUnit, const ShownUnit& valueUnit);

/// Returns the points as data of a graph. Requires points with ascending times; equal times are allowed.
GraphData graphData(const QVector<QCPGraphData>& points);

/// Returns a time history at the bit, such as the impact force, as data of a graph in the units shown. It is
/// 0 from time 0 to the first point, and constant from the last point to `timeEnd`. With Tail::cut, points
/// after `timeEnd` are removed.
GraphData historyData(QVector<QCPGraphData> points, double timeEnd, Tail tail);

}  // namespace drillwave
