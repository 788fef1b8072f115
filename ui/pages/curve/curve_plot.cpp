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
constexpr int mostColumns = 5;  // of the legend

bool sameAxes(const CurvePicture& a, const CurvePicture& b) {
    return a.xName == b.xName && a.x == b.x && a.from == b.from && a.to == b.to &&
           a.logarithmic == b.logarithmic && a.output == b.output && a.value.unit == b.value.unit;
}

QString labelOf(const QString& words, const ShownUnit& unit) {
    return unit.unit.isEmpty() ? words : unit.axisLabel(words);
}

}  // namespace

CurvePlot::CurvePlot(QCustomPlot* plot)
    : QObject(plot), m_plot(plot), m_message(nullptr), m_view(new FittedView(this)) {
    plot->setAutoAddPlottableToLegend(false);
    addRect();
    m_bands = new PresetBands(m_rect);
    m_one = new QCPItemStraightLine(plot);
    m_one->setLayer(QStringLiteral("grid"));
    m_one->setSelectable(false);
    for (QCPItemPosition* position : {m_one->point1, m_one->point2}) {
        position->setTypeX(QCPItemPosition::ptAxisRectRatio);
        position->setTypeY(QCPItemPosition::ptPlotCoords);
    }
    m_one->point1->setCoords(0, 1);
    m_one->point2->setCoords(1, 1);
    m_extremes = plot->addGraph(m_rect->axis(QCPAxis::atBottom), m_rect->axis(QCPAxis::atLeft));
    m_extremes->setLineStyle(QCPGraph::lsNone);
    m_here = new HereMark(plot, m_rect->axis(QCPAxis::atBottom), m_rect->axis(QCPAxis::atLeft));
    m_runCurves = new RunGraphs(m_rect->axis(QCPAxis::atBottom), m_rect->axis(QCPAxis::atLeft), m_legend,
                                RunGraphs::thin);
    m_runs = new RunMarks(plot, m_rect->axis(QCPAxis::atBottom), m_rect->axis(QCPAxis::atLeft));
    m_message = new PlotMessage(plot);
    for (const auto side : {QCPAxis::atBottom, QCPAxis::atLeft}) m_view->watch(m_rect->axis(side));
    connect(plot, &QCustomPlot::beforeReplot, this,
            [this] { wrapLegend(*m_legend, m_plot->width(), mostColumns); });
    setStyle(PlotStyle::forPaper());
}

void CurvePlot::addRect() {
    m_plot->plotLayout()->clear();
    m_legend = new QCPLegend;
    m_legend->setFillOrder(QCPLayoutGrid::foColumnsFirst);
    m_legend->setMargins(QMargins(7, 6, 7, 4));
    m_plot->plotLayout()->addElement(0, 0, m_legend);
    m_legend->setLayer(QStringLiteral("legend"));
    m_plot->plotLayout()->setRowStretchFactor(0, 1e-3);
    m_plot->plotLayout()->setRowSpacing(0);
    m_rect = new QCPAxisRect(m_plot);
    m_rect->setupFullAxesBox(false);
    // Drawn in the order of these lines: axes() comes in another order in every run of the program.
    for (const auto side : {QCPAxis::atLeft, QCPAxis::atRight, QCPAxis::atTop, QCPAxis::atBottom}) {
        m_rect->axis(side)->setLayer(QStringLiteral("axes"));
        m_rect->axis(side)->grid()->setLayer(QStringLiteral("grid"));
    }
    m_rect->setMinimumMargins(QMargins(4, 4, 14, 4));
    m_rect->axis(QCPAxis::atRight)->setTicks(false);
    m_plot->plotLayout()->addElement(1, 0, m_rect);
    using Changed = void (QCPAxis::*)(const QCPRange&);
    connect(m_rect->axis(QCPAxis::atBottom), static_cast<Changed>(&QCPAxis::rangeChanged), this,
            [this](const QCPRange& range) {
                m_rect->axis(QCPAxis::atTop)
                    ->setRange(range.lower * m_picture.aboveFactor, range.upper * m_picture.aboveFactor);
            });
}

void CurvePlot::present(const CurvePicture& picture) {
    const bool otherAxes = m_picture.lines.isEmpty() || !sameAxes(m_picture, picture);
    m_picture = picture;
    m_message->hide();
    makeGraphs();
    QVector<QCPGraphData> extremes;
    for (const QPointF& point : picture.extremes) extremes.append({point.x(), point.y()});
    m_extremes->data()->set(extremes);
    showAxes();
    m_bands->present(picture.bands);
    m_one->setVisible(picture.output && picture.output->name == "cor");
    setStyle(m_style);
    if (m_view->isFitted() || otherAxes) fit();
    dropMarks();
    if (picture.marked < 0) return;
    m_marks = std::make_unique<CurveMarks>(m_graphs[picture.marked]);
    m_marks->setStyle(m_style);
    m_marks->present(picture.marks, picture.x, picture.value);
}

void CurvePlot::showNothing(const QString& message) {
    m_picture = {};
    dropMarks();
    makeGraphs();
    m_bands->present({});
    m_extremes->data()->clear();
    m_one->setVisible(false);
    m_here->setPlace({}, {});
    setRuns({}, {});
    m_message->show(message);
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
            QCPGraph* graph = addCurve(m_rect->axis(QCPAxis::atBottom), m_rect->axis(QCPAxis::atLeft));
            graph->setAdaptiveSampling(false);
            graph->setName(line.name);
            graph->addToLegend(m_legend);
            m_graphs.append(graph);
        }
        m_runCurves->standLast();
    }
    for (int i = 0; i < m_graphs.size(); ++i) m_graphs[i]->setData(m_picture.lines[i].points);
}

void CurvePlot::showAxes() {
    QCPAxis* below = m_rect->axis(QCPAxis::atBottom);
    QCPAxis* above = m_rect->axis(QCPAxis::atTop);
    m_view->adjust([&] {
        const auto scale = m_picture.logarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear;
        if (below->scaleType() != scale) below->setRange(m_picture.from, m_picture.to);
        setScale(*below, scale);
    });
    below->setLabel(labelOf(m_picture.xName, m_picture.x));
    above->setLabel(m_picture.aboveName);
    above->setTickLabels(!m_picture.aboveName.isEmpty());
    if (m_picture.output)
        m_rect->axis(QCPAxis::atLeft)->setLabel(labelOf(outputName(*m_picture.output), m_picture.value));
}

void CurvePlot::setHere(std::optional<double> x, std::optional<double> y) {
    m_here->setPlace(x, y);
}

void CurvePlot::setRuns(const QVector<RunCurve>& curves, const QVector<RunMark>& marks) {
    m_runCurves->present(curves);
    m_runs->present(marks);
    if (m_view->isFitted()) fit();
}

void CurvePlot::setStyle(const PlotStyle& style) {
    m_style = style;
    if (m_message) m_message->setStyle(style);
    m_plot->setBackground(style.background);
    style.applyTo(*m_rect);
    m_rect->axis(QCPAxis::atTop)->grid()->setVisible(false);
    style.applyTo(*m_legend);
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
    m_bands->setStyle(style);
    if (m_marks) m_marks->setStyle(style);
    m_here->setStyle(style);
    m_runCurves->setStyle(style);
    m_runs->setStyle(style);
}

void CurvePlot::fit() {
    m_view->fit([&] {
        if (m_picture.lines.isEmpty()) return;
        const double room = 0.02;
        const double span = m_picture.to - m_picture.from;
        const double ratio = std::pow(m_picture.to / m_picture.from, room);
        m_rect->axis(QCPAxis::atBottom)
            ->setRange(m_picture.logarithmic ? m_picture.from / ratio : m_picture.from - room * span,
                       m_picture.logarithmic ? m_picture.to * ratio : m_picture.to + room * span);
        std::optional<QCPRange> values;
        for (const auto& graphs : {m_graphs, m_runCurves->graphs()})
            for (const QCPGraph* graph : graphs) {
                bool found = false;
                const QCPRange own = graph->getValueRange(found);
                if (!found || !graph->visible()) continue;
                if (values)
                    values->expand(own);
                else
                    values = own;
            }
        if (!values) values = QCPRange(0, 1);
        const double size = std::max(values->size(), 0.02 * std::abs(values->upper));
        // Names of presets stand at the bottom.
        const double below = m_picture.bands.isEmpty() ? 0.06 : 0.16;
        m_rect->axis(QCPAxis::atLeft)->setRange(values->lower - below * size, values->upper + 0.08 * size);
    });
}

KeyPlaces CurvePlot::keyPlaces() const {
    KeyPlaces places;
    places.rect = m_rect;
    places.start = [this] { return m_here->place(); };
    places.marks = [this] {
        QVector<QPointF> marks;
        if (m_picture.marked >= 0 && m_graphs[m_picture.marked]->visible())
            for (const CurveMark& mark : m_picture.marks) marks.append(mark.at);
        return marks;
    };
    return places;
}

CurvePlot::Target CurvePlot::targetAt(QPointF coordinates) const {
    const QCPAxis* x = m_rect->axis(QCPAxis::atBottom);
    const QCPAxis* y = m_rect->axis(QCPAxis::atLeft);
    const auto distance = [&](QPointF other) {
        return std::hypot(x->coordToPixel(other.x()) - x->coordToPixel(coordinates.x()),
                          y->coordToPixel(other.y()) - y->coordToPixel(coordinates.y()));
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
