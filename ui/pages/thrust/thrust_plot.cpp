// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/thrust/thrust_plot.h"

#include <algorithm>

#include "core/report/feed_words.h"
#include "ui/pages/thrust/regime_bands.h"
#include "ui/plot/curve_graph.h"
#include "ui/plot/legend_entries.h"
#include "ui/plot/number_ticks.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr int mostColumnsOfNeeds = 3;  // of the legend

bool sameAxes(const ThrustPicture& a, const ThrustPicture& b) {
    return a.key == b.key && a.isLogarithmic == b.isLogarithmic && a.from == b.from && a.to == b.to &&
           a.units.along.unit == b.units.along.unit && a.units.force.unit == b.units.force.unit;
}

GraphData dataOf(const QVector<QPointF>& line) {
    QVector<QCPGraphData> points;
    for (const QPointF& point : line) appendFinite(points, point.x(), point.y());
    return graphData(points);
}

}  // namespace

ThrustPlot::ThrustPlot(QCustomPlot* plot) : StudyFrame(plot) {
    plot->axisRect()->setupFullAxesBox(true);
    for (QCPAxis* far : {plot->xAxis2, plot->yAxis2}) far->setTicks(false);
    plot->axisRect()->setMinimumMargins(QMargins(4, 4, 12, 4));
    view(plot->axisRect());
    addHeader(2);
    m_legend->setWrap(mostColumnsOfNeeds);
    connect(plot, &QCustomPlot::beforeReplot, this,
            [plot] { wrapLegend(*plot->legend, plot->viewport().width(), mostColumnsOfNeeds); });
    m_bands = new RegimeBands(plot);
    for (const ThrustCase which : thrustCases) {
        const auto i = static_cast<std::size_t>(which);
        m_upper[i] = addCurve(plot->xAxis, plot->yAxis);
        m_upper[i]->removeFromLegend();
        m_upper[i]->setSelectable(QCP::stNone);
        m_lower[i] = addCurve(plot->xAxis, plot->yAxis);
        m_lower[i]->setName(coreText(labelOf(which)));
    }
    m_feed = addCurve(plot->xAxis, plot->yAxis);
    m_feedName = addText(m_rect, QMargins(6, 2, 6, 2), Qt::AlignLeft | Qt::AlignBottom);
    addHere();
    addRunMarks();
    connect(plot, &QCustomPlot::beforeReplot, this, &ThrustPlot::followLegend);
    setStyle(PlotStyle::forPaper());
    showNothing({});
}

void ThrustPlot::present(const ThrustPicture& picture) {
    const bool otherAxes = !sameAxes(m_picture, picture);
    m_picture = picture;
    for (std::size_t i = 0; i < thrustCaseCount; ++i) {
        m_lower[i]->setData(picture.needs[i].required);
        m_upper[i]->setData(picture.needs[i].returnInTime);
    }
    listKnown();
    m_feed->setData(dataOf(picture.feed));
    m_feed->setName(picture.isWeighted ? tr("effective force, with weight along the hole")
                                       : tr("installed feed force"));
    x()->setScaleType(picture.isLogarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
    x()->setTicker(picture.isLogarithmic ? QSharedPointer<QCPAxisTicker>(new NumberTicks<QCPAxisTickerLog>)
                                         : QSharedPointer<QCPAxisTicker>(new NumberTicks<QCPAxisTicker>));
    x()->setLabel(picture.units.along.axisLabel(picture.along));
    y()->setLabel(picture.units.force.axisLabel(tr("thrust")));
    finish(otherAxes);
    m_bands->present(picture);
    nameFeed();
    QStringList cases;
    for (const ThrustCase which : thrustCases)
        if (picture.needs[static_cast<std::size_t>(which)].known) cases << coreText(labelOf(which));
    m_summary = tr("Needs of the thrust over %1, for %2, each from full penetration to the bit back before "
                   "the next blow; "
                   "behind them what the feed does by the rebound of this blow.")
                    .arg(picture.along, cases.join(tr("; ")));
}

// The legend has the needs that can be told, and the feed behind them.
void ThrustPlot::listKnown() {
    const auto isKnown = [this](std::size_t i) { return m_picture.needs[i].known; };
    const auto isListed = [this](const QCPGraph* graph) { return m_legend->hasItemWithPlottable(graph); };
    bool isRight = true;
    for (std::size_t i = 0; i < thrustCaseCount; ++i) isRight &= isListed(m_lower[i]) == isKnown(i);
    if (isRight) return;
    for (QCPGraph* graph : m_lower) graph->removeFromLegend();
    m_feed->removeFromLegend();
    for (std::size_t i = 0; i < thrustCaseCount; ++i)
        if (isKnown(i)) m_lower[i]->addToLegend();
    m_feed->addToLegend();
}

void ThrustPlot::clear() {
    m_caption->setText(tr("each need from full penetration to the bit back before the next blow undamped"));
    m_picture = {};
    for (const auto& graphs : {m_lower, m_upper})
        for (QCPGraph* graph : graphs) graph->setData(GraphData::create());
    m_feed->setData(GraphData::create());
    m_bands->clear();
    nameFeed();
}

// Both ends of a bracket are one entry.
void ThrustPlot::followLegend() {
    for (std::size_t i = 0; i < thrustCaseCount; ++i) m_upper[i]->setVisible(m_lower[i]->visible());
    m_feedName->setVisible(m_feed->visible() && !m_picture.feed.isEmpty());
}

void ThrustPlot::nameFeed() {
    if (m_picture.feed.isEmpty()) return;
    const QPointF start = m_picture.feed.first();
    m_feedName->setText(QStringLiteral("%1 %2").arg(
        m_picture.isWeighted ? tr("effective") : tr("installed"),
        numberText(start.y(), 4, m_plot->locale()) + QChar(QChar::Nbsp) + m_picture.units.force.unit));
    m_feedName->position->setCoords(start);
}

std::optional<double> ThrustPlot::heightAboveFeed(QPointF pixel) const {
    if (m_picture.feed.isEmpty() || !m_rect->rect().contains(pixel.toPoint())) return std::nullopt;
    const double at = x()->pixelToCoord(pixel.x());
    const auto next = std::ranges::lower_bound(m_picture.feed, at, {}, &QPointF::x);
    if (next == m_picture.feed.end() || next == m_picture.feed.begin()) return std::nullopt;
    const QPointF before = *std::prev(next);
    const double share = (at - before.x()) / (next->x() - before.x());
    return y()->coordToPixel(before.y() + share * (next->y() - before.y())) - pixel.y();
}

void ThrustPlot::restyle() {
    const PlotStyle& style = m_style;
    m_bands->setStyle(style);
    for (std::size_t i = 0; i < thrustCaseCount; ++i) {
        const int kind = static_cast<int>(i);
        m_lower[i]->setPen(style.linePen(kind));
        QPen thin = style.linePen(kind);
        thin.setWidthF(0.8);
        m_upper[i]->setPen(thin);
        // One alone: several that lie over each other make colours that no legend explains.
        const bool isFilled = thrustCases[i] == ThrustCase::scenario;
        m_lower[i]->setBrush(isFilled ? style.areaBrush(kind) : QBrush(Qt::NoBrush));
        m_lower[i]->setChannelFillGraph(isFilled ? m_upper[i] : nullptr);
    }
    m_feed->setPen(QPen(style.text, 2.4));
    if (!m_picture.feed.isEmpty()) nameFeed();  // files have another locale
}

KeyPlaces ThrustPlot::keyPlaces() const {
    KeyPlaces places;
    places.rect = m_rect;
    places.start = [this] { return here().place(); };
    return places;
}

void ThrustPlot::setRanges() {
    double most = 0;
    for (const QCPGraph* graph : m_upper)
        for (const QCPGraphData& point : *graph->data()) most = std::max(most, point.value);
    for (const QPointF& point : m_picture.feed) most = std::max(most, point.y());
    x()->setRange(m_picture.from, m_picture.to);
    y()->setRange(0, most > 0 ? 1.06 * most : 1);
}

}  // namespace drillwave
