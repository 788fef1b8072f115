// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/drilling/scan_rects.h"

#include <algorithm>

#include "ui/plot/axis_rect.h"
#include "ui/plot/axis_view.h"
#include "ui/plot/curve_graph.h"

namespace drillwave {
namespace {

constexpr double roomAboveScan = 0.16;  // the marks have their words there
constexpr int fewTicksOfScan = 4;

}  // namespace

ScanRects::ScanRects(QCustomPlot& plot, QCPLegend& legend, QObject* parent)
    : QObject(parent), m_plot(plot), m_legend(legend) {
    m_rates = newAxisRect(plot, Sides::free);
    m_gaps = newAxisRect(plot, Sides::linked);
    for (QCPAxisRect* rect : {m_rates, m_gaps}) {
        rect->setMinimumMargins(QMargins(4, 4, 10, 4));
        plot.plotLayout()->addElement(rect);
    }
    QCPAxis *left = m_rates->axis(QCPAxis::atLeft), *right = m_rates->axis(QCPAxis::atRight);
    right->setVisible(true);
    right->setTickLabels(true);
    right->setLabel(tr("blows in contact [%]"));  // blows, as the legend has them
    right->ticker()->setTickCount(fewTicksOfScan);
    m_low = add(m_rates, left, {}, false);
    m_high = add(m_rates, left, {}, false);
    m_high->setChannelFillGraph(m_low);
    m_share = add(m_rates, right, tr("blows in contact"), false);
    m_constantForce = add(m_rates, left, tr("constant force"), false);
    m_strongDamper = add(m_rates, left, tr("dashpot of half the impedance"), false);
    m_rate = add(m_rates, left, tr("penetration rate"), false);
    m_other = add(m_rates, left, tr("started bouncing"), true);
    m_dots = add(m_gaps, m_gaps->axis(QCPAxis::atLeft), {}, true);
    m_otherDots = add(m_gaps, m_gaps->axis(QCPAxis::atLeft), {}, true);
    for (QCPGraph* graph : {m_low, m_high, m_dots, m_otherDots}) graph->setSelectable(QCP::stNone);
}

QCPGraph* ScanRects::add(QCPAxisRect* rect, QCPAxis* values, const QString& name, bool hasPoints) {
    QCPAxis* along = rect->axis(QCPAxis::atBottom);
    QCPGraph* graph = hasPoints ? m_plot.addGraph(along, values) : addCurve(along, values);
    if (hasPoints) graph->setLineStyle(QCPGraph::lsNone);
    graph->setName(name);
    return graph;
}

// The legend has what is there.
void ScanRects::list(QCPGraph* graph, bool isListed) {
    if (m_legend.hasItemWithPlottable(graph) == isListed) return;
    if (isListed)
        graph->addToLegend(&m_legend);
    else
        graph->removeFromLegend(&m_legend);
}

void ScanRects::present(const ScanPicture& picture, const DrillingShown& units, bool isOld) {
    m_from = picture.from;
    m_to = picture.to;
    m_isOld = isOld;
    const std::pair<QCPGraph*, const QVector<QCPGraphData>*> data[] = {
        {m_rate, &picture.scan.rate},
        {m_low, &picture.scan.low},
        {m_high, &picture.scan.high},
        {m_share, &picture.scan.contactShare},
        {m_other, &picture.scan.otherRate},
        {m_constantForce, &picture.constantForce},
        {m_strongDamper, &picture.strongDamper},
        {m_dots, &picture.scan.gaps},
        {m_otherDots, &picture.scan.otherGaps}};
    for (const auto& [graph, points] : data) graph->setData(graphData(*points));
    for (QCPGraph* graph : {m_rate, m_share, m_other, m_constantForce, m_strongDamper})
        list(graph, !graph->data()->isEmpty());
    const QString along =
        isOld ? tr("%1 (of an earlier scenario: scan again)").arg(picture.along) : picture.along;
    for (QCPAxisRect* rect : {m_rates, m_gaps}) {
        QCPAxis* axis = rect->axis(QCPAxis::atBottom);
        axis->setLabel(units.along.axisLabel(along));
        const auto scale = picture.isLogarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear;
        if (axis->scaleType() != scale) axis->setRange(m_from, m_to);
        setScale(*axis, scale);
    }
    m_rates->axis(QCPAxis::atLeft)->setLabel(units.rate.axisLabel(tr("penetration rate")));
    m_gaps->axis(QCPAxis::atLeft)->setLabel(units.length.axisLabel(tr("gap at the blow")));
    showMarks(picture);
}

void ScanRects::showMarks(const ScanPicture& picture) {
    for (const Mark& mark : m_marks) {
        m_plot.removeItem(mark.line);
        m_plot.removeItem(mark.words);
    }
    m_marks.clear();
    for (const ScanPicture::Mark& each : picture.marks) {
        Mark mark{addItem<QCPItemStraightLine>(m_rates), addItem<QCPItemText>(m_rates)};
        for (QCPItemPosition* end : mark.line->positions()) end->setTypeY(QCPItemPosition::ptAxisRectRatio);
        mark.line->point1->setCoords(each.at, 0);
        mark.line->point2->setCoords(each.at, 1);
        mark.words->position->setTypeY(QCPItemPosition::ptAbsolute);
        mark.words->setPositionAlignment(Qt::AlignLeft | Qt::AlignBottom);
        mark.words->setText(each.words);
        m_marks.append(mark);
    }
}

// Places the words at the foot, where rates are zero, each in the first row with enough free room.
void ScanRects::placeMarks() {
    constexpr int margin = 3;
    QVector<double> ends;  // of each row
    for (const Mark& mark : m_marks) {
        const QFontMetrics metrics(mark.words->font());
        const double from = m_rates->axis(QCPAxis::atBottom)->coordToPixel(mark.line->point1->key());
        const auto free = std::find_if(ends.begin(), ends.end(), [from](double end) { return end <= from; });
        const auto row = static_cast<int>(free - ends.begin());
        if (free == ends.end()) ends.append(0);
        ends[row] = from + 2 * margin + metrics.horizontalAdvance(mark.words->text());
        mark.words->position->setPixelPosition(
            {from + margin, m_rates->bottom() - margin - double(row * metrics.height())});
    }
}

QStringList ScanRects::marks() const {
    QStringList words;
    for (const Mark& mark : m_marks) words << mark.words->text();
    return words;
}

void ScanRects::setStyle(const PlotStyle& style) {
    const auto pen = [&](int kind) { return m_isOld ? style.ghostPen(kind) : style.linePen(kind); };
    m_low->setPen(Qt::NoPen);
    m_high->setPen(Qt::NoPen);
    m_high->setBrush(m_isOld ? QBrush(Qt::NoBrush) : style.areaBrush(0));
    m_rate->setPen(pen(0));
    m_rate->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, pen(0).color(), pen(0).color(), 4));
    m_share->setPen(pen(1));
    m_constantForce->setPen(pen(2));
    m_strongDamper->setPen(pen(3));
    m_other->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssDiamond, QPen(pen(0).color(), 1.2), Qt::NoBrush, 8));
    const auto dots = [&](QCPGraph* graph, const QColor& colour) {
        graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, colour, colour, 2));
    };
    dots(m_dots, m_isOld ? style.frame : style.lines[0]);
    // as in the legend
    m_otherDots->setScatterStyle(QCPScatterStyle(
        QCPScatterStyle::ssDiamond, QPen(m_isOld ? style.frame : pen(0).color(), 0.8), Qt::NoBrush, 5));
    for (const Mark& mark : m_marks) {
        mark.line->setPen(QPen(style.frame, 1, Qt::DashLine));
        mark.words->setFont(style.font);
        mark.words->setColor(style.text);
        QColor veil = style.background;
        veil.setAlphaF(0.85F);  // the lines below the words hardly show through
        mark.words->setBrush(veil);
    }
}

void ScanRects::fit() {
    double mostRate = 0, mostGap = 0;
    for (const QCPGraph* graph : {m_high, m_rate, m_other, m_constantForce, m_strongDamper})
        for (const QCPGraphData& point : *graph->data()) mostRate = std::max(mostRate, point.value);
    for (const QCPGraph* graph : {m_dots, m_otherDots})
        for (const QCPGraphData& point : *graph->data()) mostGap = std::max(mostGap, point.value);
    for (QCPAxisRect* rect : {m_rates, m_gaps}) rect->axis(QCPAxis::atBottom)->setRange(m_from, m_to);
    m_rates->axis(QCPAxis::atLeft)->setRange(0, mostRate > 0 ? (1 + roomAboveScan) * mostRate : 1);
    m_rates->axis(QCPAxis::atRight)->setRange(0, 100 * (1 + roomAboveScan));
    const double top = mostGap > 0 ? mostGap : 1;
    m_gaps->axis(QCPAxis::atLeft)->setRange(-0.03 * top, 1.06 * top);
}

}  // namespace drillwave
