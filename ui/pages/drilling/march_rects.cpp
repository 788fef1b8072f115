// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/drilling/march_rects.h"

#include <algorithm>
#include <cmath>

#include "ui/plot/axis_rect.h"
#include "ui/plot/curve_graph.h"
#include "ui/text/number_text.h"

namespace drillwave {
namespace {

constexpr double roomAbovePoints = 0.06;
constexpr double partWidth = 0.95;  // of a bar
constexpr int fewTicksOfMarch = 4, fewestTicksOfMarch = 2;
constexpr double leastRangeOfReturns = 0.1;  // of the gap: ticks of less have too many digits

QCPAxis* below(const QCPAxisRect* rect) {
    return rect->axis(QCPAxis::atBottom);
}
QCPAxis* beside(const QCPAxisRect* rect) {
    return rect->axis(QCPAxis::atLeft);
}

void setPoints(QCPGraph& graph, const QVector<QPointF>& points) {
    QVector<QCPGraphData> data;
    data.reserve(points.size());
    for (const QPointF& point : points) appendFinite(data, point.x(), point.y());
    graph.setData(graphData(data));
}

}  // namespace

MarchRects::MarchRects(QCustomPlot& plot, QObject* parent)
    : QObject(parent), m_plot(plot), m_details(new QCPLayoutGrid) {
    m_details->setColumnSpacing(6);
    plot.plotLayout()->addElement(m_details);
    m_gaps = addSeries();
    m_penetrations = addSeries();
    addDetails();
    m_runs = new RunMarks(&plot, below(m_penetrations.rect), beside(m_penetrations.rect));
}

QCPGraph* MarchRects::addPoints(QCPAxisRect* rect) {
    QCPGraph* graph = m_plot.addGraph(below(rect), beside(rect));
    graph->setLineStyle(QCPGraph::lsNone);
    graph->setSelectable(QCP::stNone);
    return graph;
}

MarchRects::Series MarchRects::addSeries() {
    Series series{};
    series.rect = newAxisRect(m_plot, Sides::linked);
    series.rect->setMinimumMargins(QMargins(4, 6, 10, 4));
    m_plot.plotLayout()->addElement(series.rect);
    series.settled = addItem<QCPItemRect>(series.rect, QStringLiteral("grid"));
    for (QCPItemPosition* corner : {series.settled->topLeft, series.settled->bottomRight})
        corner->setTypeY(QCPItemPosition::ptAxisRectRatio);
    series.settled->setPen(Qt::NoPen);
    series.before = addPoints(series.rect);
    series.before->setLayer(ghostLayer(m_plot));
    series.now = addPoints(series.rect);
    below(series.rect)->setLabel(tr("blow (shaded: counted)"));
    below(series.rect)->ticker()->setTickCount(fewTicksOfMarch);
    return series;
}

void MarchRects::addDetails() {
    m_partsRect = newAxisRect(m_plot, Sides::free);
    m_returnRect = newAxisRect(m_plot, Sides::linked);
    m_energyRect = newAxisRect(m_plot, Sides::linked);
    int column = 0;
    auto* bottoms = new QCPMarginGroup(&m_plot);  // one label has two lines
    for (QCPAxisRect* rect : {m_partsRect, m_returnRect, m_energyRect}) {
        rect->setMinimumMargins(QMargins(4, 6, 10, 4));
        rect->setMarginGroup(QCP::msBottom, bottoms);
        m_details->addElement(0, column++, rect);
        below(rect)->ticker()->setTickCount(fewestTicksOfMarch);
    }
    m_parts = new QCPBars(below(m_partsRect), beside(m_partsRect));
    m_parts->setSelectable(QCP::stNone);
    below(m_partsRect)->setLabel(tr("gap modulo d₀, in d₀"));
    beside(m_partsRect)->setLabel(tr("blows [%]"));
    QCPAxis* right = m_partsRect->axis(QCPAxis::atRight);
    right->setVisible(true);
    right->setTickLabels(true);
    right->ticker()->setTickCount(fewTicksOfMarch);
    right->setLabel(tr("e at this gap"));
    m_cor = addCurve(below(m_partsRect), right);
    m_cor->setSelectable(QCP::stNone);
    m_returnPoints = addPoints(m_returnRect);
    m_returns = new QCPCurve(below(m_returnRect), beside(m_returnRect));
    m_returns->setSelectable(QCP::stNone);
    m_energy = new QCPBars(beside(m_energyRect), below(m_energyRect));
    m_energy->setSelectable(QCP::stNone);
    m_energy->setWidth(0.7);
    below(m_energyRect)->setLabel(tr("share of the energy [%]"));
    for (QCPAxis* axis : {below(m_energyRect), beside(m_energyRect)})
        axis->grid()->setVisible(false);  // it would strike the numbers through
}

void MarchRects::present(const MarchPicture& picture, const BlowPoints& before, const DrillingShown& units) {
    m_blows = double(std::max(picture.blows, 1L));
    setPoints(*m_gaps.now, picture.now.gaps);
    setPoints(*m_penetrations.now, picture.now.penetrations);
    setPoints(*m_gaps.before, before.gaps);
    setPoints(*m_penetrations.before, before.penetrations);
    for (const Series& series : {m_gaps, m_penetrations}) showSettled(series, picture);
    beside(m_gaps.rect)->setLabel(units.length.axisLabel(tr("gap at the blow")));
    beside(m_penetrations.rect)->setLabel(units.length.axisLabel(tr("penetration")));

    const auto count = double(picture.parts.size());
    QVector<double> places, shares;
    for (std::size_t i = 0; i < picture.parts.size(); ++i) {
        places.append((double(i) + 0.5) / count);
        shares.append(picture.parts[i]);
    }
    m_parts->setWidth(count > 0 ? partWidth / count : 1);
    m_parts->setData(places, shares, true);
    setPoints(*m_cor, picture.cor);
    m_partsRect->axis(QCPAxis::atRight)->setVisible(!picture.cor.isEmpty());

    setPoints(*m_returnPoints, picture.returns);
    QVector<QCPCurveData> path;
    for (const QPointF& step : picture.lastReturns) path.append({double(path.size()), step.x(), step.y()});
    m_returns->data()->set(path, true);
    below(m_returnRect)
        ->setLabel(units.length.axisLabel(tr("gap")) + tr("\na projection from more dimensions"));
    beside(m_returnRect)->setLabel(units.length.axisLabel(tr("next gap")));
    showEnergy(picture);
}

std::optional<long> MarchRects::blowAt(const QCPAxisRect* rect, double x) const {
    if (rect != m_gaps.rect && rect != m_penetrations.rect) return std::nullopt;
    const auto blow = std::lround(x);
    if (blow < 1 || blow > m_gaps.now->dataCount()) return std::nullopt;
    return blow;
}

// Those that count.
void MarchRects::showSettled(const Series& series, const MarchPicture& picture) {
    series.settled->setVisible(picture.blows > 0);
    series.settled->topLeft->setCoords(double(picture.settle) + 0.5, 0);
    series.settled->bottomRight->setCoords(double(picture.blows) + 0.5, 1);
}

// One bar below the other, with its name and its share.
void MarchRects::showEnergy(const MarchPicture& picture) {
    for (QCPItemText* text : m_shares) m_plot.removeItem(text);
    m_shares.clear();
    const QSharedPointer<QCPAxisTickerText> names(new QCPAxisTickerText);
    QVector<double> places, shares;
    for (const MarchPicture::Share& part : picture.energy) {
        const double place = -double(places.size());
        names->addTick(place, part.name);
        places.append(place);
        shares.append(100 * part.share);
        auto* text = addItem<QCPItemText>(m_energyRect);
        text->setText(numberText(std::round(1000 * part.share) / 10, 3, m_plot.locale()));
        text->setPositionAlignment(Qt::AlignLeft | Qt::AlignVCenter);
        text->position->setCoords(std::max(0.0, 100 * part.share), place);
        text->setPadding(QMargins(4, 0, 0, 0));
        m_shares.append(text);
    }
    m_energy->setData(places, shares);
    beside(m_energyRect)->setTicker(names);
}

void MarchRects::presentRuns(const QVector<RunMark>& means) {
    m_runs->present(means);
}

void MarchRects::setStyle(const PlotStyle& style) {
    m_runs->setStyle(style);
    for (const Series& series : {m_gaps, m_penetrations}) {
        const int kind = series.rect == m_gaps.rect ? 0 : 1;
        series.now->setScatterStyle(
            QCPScatterStyle(QCPScatterStyle::ssDisc, style.lines[kind], style.lines[kind], 3));
        series.before->setScatterStyle(
            QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(style.frame, 1), Qt::NoBrush, 3));
        QColor shade = style.frame;
        shade.setAlphaF(0.14F);
        series.settled->setBrush(shade);
    }
    m_parts->setPen(QPen(style.lines[0], 1));
    m_parts->setBrush(style.areaBrush(0));
    m_cor->setPen(style.linePen(1));
    m_returnPoints->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssDisc, style.lines[0], style.lines[0], 3));
    QPen path(style.lines[2], 1);
    m_returns->setPen(path);
    m_returns->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, path, Qt::NoBrush, 5));
    m_energy->setPen(QPen(style.lines[0], 1));
    m_energy->setBrush(style.areaBrush(0));
    for (QCPItemText* text : m_shares) {
        text->setFont(style.font);
        text->setColor(style.text);
    }
}

void MarchRects::fitSeries(const Series& series) {
    double most = 0;
    for (const QCPGraphData& point : *series.now->data()) most = std::max(most, point.value);
    if (series.rect == m_penetrations.rect)
        for (const RunMark& run : m_runs->marks()) most = std::max(most, run.at.y());
    below(series.rect)->setRange(0, m_blows + 1);
    // A gap of none is drawn on the axis, and is to be seen there.
    const double top = most > 0 ? most : 1;
    beside(series.rect)->setRange(-roomAbovePoints * top, (1 + roomAbovePoints) * top);
}

void MarchRects::fit() {
    fitSeries(m_gaps);
    fitSeries(m_penetrations);
    below(m_partsRect)->setRange(0, 1);
    double mostShare = 0;
    for (const QCPBarsData& part : *m_parts->data()) mostShare = std::max(mostShare, part.value);
    beside(m_partsRect)->setRange(0, mostShare > 0 ? (1 + roomAbovePoints) * mostShare : 100);
    bool isFound = false;
    const QCPRange cor = m_cor->getValueRange(isFound);
    if (isFound) {
        const double room = std::max(roomAbovePoints * cor.size(), 0.01);
        m_partsRect->axis(QCPAxis::atRight)->setRange(cor.lower - room, cor.upper + room);
    }
    const QCPRange gaps = m_returnPoints->getValueRange(isFound);
    const double most = isFound && gaps.upper > 0 ? gaps.upper : 1;
    const double least = isFound ? std::min(gaps.lower, most) : 0;
    const double room =
        std::max(roomAbovePoints * (most - least), (leastRangeOfReturns * most - (most - least)) / 2);
    for (QCPAxis* axis : {below(m_returnRect), beside(m_returnRect)})
        axis->setRange(least - room, most + room);
    double lowest = 0, highest = 0;
    for (const QCPBarsData& part : *m_energy->data()) {
        lowest = std::min(lowest, part.value);
        highest = std::max(highest, part.value);
    }
    constexpr double roomForNumbers = 1.6;
    below(m_energyRect)->setRange(1.1 * lowest, highest > 0 ? roomForNumbers * highest : 100);
    beside(m_energyRect)->setRange(-double(m_energy->dataCount()) + 0.4, 0.6);
}

}  // namespace drillwave
