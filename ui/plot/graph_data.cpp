// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/graph_data.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace drillwave {
namespace {

void cutAt(QVector<QCPGraphData>& points, double end) {
    const auto behind =
        std::find_if(points.begin(), points.end(), [end](const auto& point) { return point.key > end; });
    if (behind == points.begin() || behind == points.end()) return;
    const QCPGraphData& before = *(behind - 1);
    const double share = (end - before.key) / (behind->key - before.key);
    *behind = QCPGraphData(end, before.value + share * (behind->value - before.value));
    points.erase(behind + 1, points.end());
}

}  // namespace

void appendFinite(QVector<QCPGraphData>& points, double time, double value) {
    if (std::isfinite(time) && std::isfinite(value)) points.append(QCPGraphData(time, value));
}

QVector<QCPGraphData> shownPoints(const std::vector<double>& time, const std::vector<double>& value,
                                  const ShownUnit& timeUnit, const ShownUnit& valueUnit) {
    QVector<QCPGraphData> points;
    points.reserve(static_cast<qsizetype>(time.size()) + 3);
    for (std::size_t i = 0; i < time.size(); ++i)
        appendFinite(points, time[i] * timeUnit.factor, value[i] * valueUnit.factor);
    return points;
}

GraphData graphData(const QVector<QCPGraphData>& points) {
    auto data = GraphData::create();
    data->set(points, true);
    return data;
}

GraphData historyData(QVector<QCPGraphData> points, double timeEnd, Tail tail) {
    if (points.isEmpty()) return graphData(points);
    if (points.first().key > 0) {
        points.prepend(QCPGraphData(points.first().key, 0));
        points.prepend(QCPGraphData(0, 0));
    }
    if (points.last().key < timeEnd) points.append(QCPGraphData(timeEnd, points.last().value));
    if (tail == Tail::cut) cutAt(points, timeEnd);
    return graphData(points);
}

}  // namespace drillwave
