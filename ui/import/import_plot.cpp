// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/import_plot.h"

#include <algorithm>

#include "ui/plot/curve_graph.h"
#include "ui/plot/graph_data.h"
#include "ui/plot/plot_widget.h"
#include "ui/text/shown_text.h"
#include "ui/text/typed_text.h"
#include "ui/text/unit_choice.h"

namespace drillwave {
namespace {

double largest(const QPolygonF& points) {
    double size = 0;
    for (const QPointF& point : points) size = std::max(size, std::abs(point.y()));
    return size;
}

QCPRange padded(double low, double high) {
    if (!(high > low)) return {low - 1, low + 1};
    const double room = 0.06 * (high - low);
    return {low - room, high + room};
}

}  // namespace

ImportPlot::ImportPlot(PlotWidget* plot, const UnitChoice& units)
    : StudyFrame(plot),
      m_units(units),
      m_record(addCurve(plot->xAxis, plot->yAxis)),
      m_taken(addCurve(plot->xAxis, plot->yAxis)) {
    plot->axisRect()->setupFullAxesBox(true);
    plot->axisRect()->setMinimumMargins(QMargins(4, 4, 12, 4));
    insertAbove(plot->legend);
    useLegend(plot->legend->margins());
    m_record->setName(tr("record"));
    m_taken->setName(tr("used"));
    view(plot->axisRect());
    plot->followPalette([this](const PlotStyle& style) { setStyle(style); });
    connect(plot, &PlotWidget::fitRequested, this, &ImportPlot::fit);
}

void ImportPlot::restyle() {
    m_record->setPen(m_style.ghostPen(0));
    m_taken->setPen(QPen(m_style.lines[1], m_style.lineWidth));
}

void ImportPlot::present(const ImportPreview& preview, double shift, const QString& axis) {
    const Unit& time = m_units.unitFor(UnitKind::time, preview.time.to - preview.time.from);
    const Unit& force = m_units.unitFor(UnitKind::force, largest(preview.record));
    const bool unitsChanged = m_timeFactor != 1 / time.factor() || m_forceUnit != &force;
    m_timeFactor = 1 / time.factor();
    m_forceUnit = &force;
    QVector<QCPGraphData> record, taken;
    for (const QPointF& point : preview.record)
        appendFinite(record, time.fromSi(point.x()), force.fromSi(point.y()));
    for (const TablePoint& point : preview.signal.points)
        appendFinite(taken, time.fromSi(point.time + shift), force.fromSi(point.force));
    m_record->setData(graphData(record));
    m_taken->setData(graphData(taken));
    x()->setLabel(tr("time in the file [%1]").arg(shownUnitName(time.name)));
    y()->setLabel(QStringLiteral("%1 [%2]").arg(axis, shownUnitName(force.name)));
    finish(unitsChanged);
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void ImportPlot::clear() {
    for (QCPGraph* graph : {m_record, m_taken}) graph->setData(GraphData::create());
}

void ImportPlot::setRanges() {
    bool any = false;
    double left = 0, right = 0, low = 0, high = 0;
    for (const QCPGraph* graph : {m_record, m_taken})
        for (auto point = graph->data()->constBegin(); point != graph->data()->constEnd(); ++point) {
            left = any ? std::min(left, point->key) : point->key;
            right = any ? std::max(right, point->key) : point->key;
            low = std::min(low, point->value);
            high = std::max(high, point->value);
            any = true;
        }
    x()->setRange(any && right > left ? QCPRange(left, right) : padded(left, right));
    y()->setRange(padded(low, high));
}

RecordSpan ImportPlot::visibleTimes() const {
    const QCPRange range = x()->range();
    return {range.lower / m_timeFactor, range.upper / m_timeFactor};
}

}  // namespace drillwave
