// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/curve/curve_plot.h"

#include <algorithm>
#include <cmath>

#include "ui/pages/study/output_box.h"
#include "ui/plot/axis_view.h"
#include "ui/plot/curve_graph.h"
#include "ui/plot/legend_entries.h"

namespace drillwave {
namespace {

constexpr double nearPixels = 9;
constexpr int mostColumnsOfCurves = 5;  // of the legend

bool sameAxes(const CurvePicture& a, const CurvePicture& b) {
    return a.xName == b.xName && a.x == b.x && a.from == b.from && a.to == b.to &&
           a.logarithmic == b.logarithmic && a.output == b.output && a.value.unit == b.value.unit;
}

}  // namespace

CurvePlot::CurvePlot(QCustomPlot* plot) : StudyFrame(plot) {
    layOutAnew();
    addRect();
    m_bands = new PresetBands(m_rect);
    m_one = addLevel(m_rect, QStringLiteral("grid"));
    m_goal = addLevel(m_rect, QStringLiteral("grid"));
    m_extremes = plot->addGraph(x(), y());
    m_extremes->setLineStyle(QCPGraph::lsNone);
    addHere();
    addRunCurves(RunGraphs::thin);
    addRunMarks();
    connect(plot, &QCustomPlot::beforeReplot, this,
            [this] { wrapLegend(*m_legend, m_plot->width(), mostColumnsOfCurves); });
    setStyle(PlotStyle::forPaper());
}

void CurvePlot::addRect() {
    useLegend(QMargins(7, 6, 7, 4));
    insertAbove(m_legend);
    m_legend->setLayer(QStringLiteral("legend"));
    view(newAxisRect(*m_plot, Sides::free));
    m_rect->setMinimumMargins(QMargins(4, 4, 14, 4));
    m_rect->axis(QCPAxis::atRight)->setTicks(false);
    m_plot->plotLayout()->addElement(1, 0, m_rect);
    connect(x(), qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this, [this](const QCPRange& range) {
        m_rect->axis(QCPAxis::atTop)
            ->setRange(range.lower * m_picture.aboveFactor, range.upper * m_picture.aboveFactor);
    });
}

void CurvePlot::present(const CurvePicture& picture) {
    const bool otherAxes = m_picture.lines.isEmpty() || !sameAxes(m_picture, picture);
    m_picture = picture;
    m_summary = picture.summary;
    makeGraphs();
    QVector<QCPGraphData> extremes;
    for (const QPointF& point : picture.extremes) extremes.append({point.x(), point.y()});
    m_extremes->data()->set(extremes);
    showAxes();
    m_bands->present(picture.bands);
    setLevel(*m_one, picture.output && picture.output->name == "cor" ? std::optional(1.0) : std::nullopt);
    setLevel(*m_goal, picture.goal);
    setStyle(m_style);
    finish(otherAxes);
    dropMarks();
    if (picture.marked < 0) return;
    m_marks = std::make_unique<CurveMarks>(m_graphs[picture.marked]);
    m_marks->setStyle(m_style);
    m_marks->present(picture.marks, picture.x, picture.value);
}

void CurvePlot::clear() {
    m_picture = {};
    dropMarks();
    makeGraphs();
    m_bands->present({});
    m_extremes->data()->clear();
    setLevel(*m_one, {});
    setLevel(*m_goal, {});
}

void CurvePlot::dropMarks() {
    if (m_marks) m_marks->clear();
    m_marks.reset();
}

// The ones there are stay as long as their names do: what was hidden by its legend entry stays hidden.
void CurvePlot::makeGraphs() {
    const bool sameNames =
        m_graphs.size() == m_picture.lines.size() &&
        std::equal(m_graphs.begin(), m_graphs.end(), m_picture.lines.begin(),
                   [](const QCPGraph* graph, const DrawnCurve& line) { return graph->name() == line.name; });
    if (!sameNames) {
        dropMarks();
        for (QCPGraph* graph : m_graphs) m_plot->removeGraph(graph);
        m_legend->clearItems();
        m_graphs.clear();
        for (const DrawnCurve& line : m_picture.lines) {
            QCPGraph* graph = addCurve(x(), y());
            graph->setAdaptiveSampling(false);
            graph->setName(line.name);
            graph->addToLegend(m_legend);
            m_graphs.append(graph);
        }
        standRunsLast();
    }
    for (int i = 0; i < m_graphs.size(); ++i) m_graphs[i]->setData(m_picture.lines[i].points);
}

void CurvePlot::showAxes() {
    QCPAxis* above = m_rect->axis(QCPAxis::atTop);
    m_view->adjust([&] {
        const auto scale = m_picture.logarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear;
        if (x()->scaleType() != scale) x()->setRange(m_picture.from, m_picture.to);
        setScale(*x(), scale);
    });
    x()->setLabel(m_picture.x.axisLabel(m_picture.xName));
    above->setLabel(m_picture.aboveName);
    above->setTickLabels(!m_picture.aboveName.isEmpty());
    if (m_picture.output) y()->setLabel(m_picture.value.axisLabel(outputName(*m_picture.output)));
}

void CurvePlot::restyle() {
    const PlotStyle& style = m_style;
    m_rect->axis(QCPAxis::atTop)->grid()->setVisible(false);
    for (int i = 0; i < m_graphs.size(); ++i) {
        const DrawnCurve& line = m_picture.lines[i];
        QPen pen = style.linePen(line.number);
        switch (line.kind) {
            case DrawnCurve::Kind::curve:
                if (line.isHere) pen.setWidthF(1.6 * pen.widthF());
                break;
            case DrawnCurve::Kind::reference:
                pen.setWidthF(0.6 * pen.widthF());
                pen.setDashPattern({2, 3});
                pen.setCapStyle(Qt::FlatCap);
                break;
            case DrawnCurve::Kind::closedForm:
                pen = QPen(style.text, pen.widthF());
                pen.setDashPattern({7, 5});
                pen.setCapStyle(Qt::FlatCap);
                break;
        }
        m_graphs[i]->setPen(pen);
    }
    m_extremes->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(style.text, 1), style.background, 5));
    m_one->setPen(QPen(style.text, 1, Qt::DashDotLine));
    m_goal->setPen(QPen(style.text, 1.4, Qt::DashLine));
    m_bands->setStyle(style);
    if (m_marks) m_marks->setStyle(style);
}

void CurvePlot::setRanges() {
    if (m_picture.lines.isEmpty()) return;
    const double room = 0.02;
    const double span = m_picture.to - m_picture.from;
    const double ratio = std::pow(m_picture.to / m_picture.from, room);
    x()->setRange(m_picture.logarithmic ? m_picture.from / ratio : m_picture.from - room * span,
                  m_picture.logarithmic ? m_picture.to * ratio : m_picture.to + room * span);
    std::optional<QCPRange> values;
    for (const QCPGraph* graph : m_graphs + runCurves()) {
        bool found = false;
        const QCPRange own = graph->getValueRange(found);
        if (!found || !graph->visible()) continue;
        if (values)
            values->expand(own);
        else
            values = own;
    }
    if (!values) values = QCPRange(0, 1);
    // A goal that nothing comes near would make the curves flat.
    if (m_picture.goal &&
        values->expanded(QCPRange(*m_picture.goal, *m_picture.goal)).size() <= 2 * values->size())
        values->expand(*m_picture.goal);
    const double size = std::max(values->size(), 0.02 * std::abs(values->upper));
    // Names of presets are at the bottom.
    const double below = m_picture.bands.isEmpty() ? 0.06 : 0.16;
    y()->setRange(values->lower - below * size, values->upper + 0.08 * size);
}

KeyPlaces CurvePlot::keyPlaces() const {
    KeyPlaces places;
    places.rect = m_rect;
    places.start = [this] { return here().place(); };
    places.marks = [this] {
        QVector<QPointF> marks;
        if (m_picture.marked >= 0 && m_graphs[m_picture.marked]->visible())
            for (const CurveMark& mark : m_picture.marks) marks.append(mark.at);
        return marks;
    };
    return places;
}

CurvePlot::Target CurvePlot::targetAt(QPointF coordinates) const {
    const auto distance = [&](QPointF other) {
        return QLineF(pixelOf(other), pixelOf(coordinates)).length();
    };
    Target target{.x = coordinates.x()};
    double nearest = nearPixels;
    for (const CurveMark& mark : m_picture.marks) {
        if (distance(mark.at) >= nearest) continue;
        nearest = distance(mark.at);
        target = {mark.at.x(), m_picture.marked, true};
    }
    if (target.line >= 0) return target;
    for (int i = 0; i < m_graphs.size(); ++i) {
        if (m_picture.lines[i].kind != DrawnCurve::Kind::curve || !m_graphs[i]->realVisibility()) continue;
        const auto data = m_graphs[i]->data();
        auto after = data->findBegin(coordinates.x(), false);
        if (after == data->constEnd()) continue;
        const auto before = after == data->constBegin() ? after : std::prev(after);
        const double width = after->key - before->key;
        const double share = width > 0 ? (coordinates.x() - before->key) / width : 0;
        const double value = before->value + share * (after->value - before->value);
        if (!(distance({coordinates.x(), value}) < nearest)) continue;
        nearest = distance({coordinates.x(), value});
        target.line = i;
    }
    return target;
}

}  // namespace drillwave
