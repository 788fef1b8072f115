// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/accuracy/proof_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/plot/curve_graph.h"

namespace drillwave {
namespace {

void makeLogarithmic(QCPAxis& axis) {
    axis.setScaleType(QCPAxis::stLogarithmic);
    axis.setTicker(QSharedPointer<QCPAxisTickerLog>::create());
    axis.setNumberFormat(QStringLiteral("eb"));
    axis.setNumberPrecision(0);
}

// Shape, colour and filling differ, never only the colour.
QCPScatterStyle scatterOf(ProofSeries::Points points, int index, const PlotStyle& style) {
    using Shape = QCPScatterStyle::ScatterShape;
    constexpr Shape shapes[] = {QCPScatterStyle::ssDisc,     QCPScatterStyle::ssSquare,
                                QCPScatterStyle::ssTriangle, QCPScatterStyle::ssDiamond,
                                QCPScatterStyle::ssCross,    QCPScatterStyle::ssPlus,
                                QCPScatterStyle::ssCircle,   QCPScatterStyle::ssTriangleInverted};
    const QColor colour = style.lines[index % PlotStyle::lineKinds];
    if (points == ProofSeries::Points::star)
        return QCPScatterStyle(QCPScatterStyle::ssStar, QPen(colour, 2), Qt::NoBrush, 15);
    const double size = points == ProofSeries::Points::joined ? 6 : 5;
    return QCPScatterStyle(shapes[index % std::size(shapes)], QPen(colour, 1.3), QBrush(style.background),
                           size);
}

// The decades around all of one coordinate of the points.
QCPRange decadesOf(const ProofPicture& picture, double (QPointF::*coordinate)() const,
                   std::optional<double> also) {
    double least = also.value_or(HUGE_VAL), most = also.value_or(0);
    for (const ProofSeries& series : picture.series)
        for (const QPointF& point : series.at) {
            least = std::min(least, (point.*coordinate)());
            most = std::max(most, (point.*coordinate)());
        }
    if (!(least <= most)) return {1e-3, 1};
    constexpr double room = 3;  // a factor
    return {least / room, most * room};
}

}  // namespace

ProofPlot::ProofPlot(QCustomPlot* plot) : StudyFrame(plot) {
    plot->setAutoAddPlottableToLegend(false);
    plot->axisRect()->setupFullAxesBox(true);
    plot->axisRect()->setMinimumMargins(QMargins(4, 4, 14, 4));
    connect(plot, &QCustomPlot::afterLayout, this, &ProofPlot::placeLabels);
    view(plot->axisRect());
    for (QCPAxis* axis : {plot->xAxis, plot->yAxis, plot->xAxis2, plot->yAxis2}) makeLogarithmic(*axis);
    QCPLayoutGrid* header = addHeader(4);
    m_legend->setWrap(4);
    // Takes what width is left: a legend without entries would keep the axes as narrow as itself.
    header->addElement(0, 1, new QCPTextElement(plot));
    m_mark = addLevel(m_rect);
    m_markName = addText(m_rect, QMargins(6, 2, 6, 2), Qt::AlignLeft | Qt::AlignBottom);
    m_markName->setVisible(false);
    setAcross(*m_markName->position);
    setStyle(PlotStyle::forPaper());
}

void ProofPlot::clearPoints() {
    for (QCPGraph* graph : m_graphs) m_plot->removeGraph(graph);
    for (QCPItemText* label : m_labels) m_plot->removeItem(label);
    m_graphs.clear();
    m_labels.clear();
}

void ProofPlot::present(const ProofPicture& picture) {
    const bool otherAxes = m_picture.xLabel != picture.xLabel;
    clearPoints();
    m_picture = picture;
    x()->setLabel(picture.xLabel);
    y()->setLabel(picture.yLabel);
    m_summary = picture.caption;
    m_caption->setText(picture.caption);
    for (std::size_t i = 0; i < picture.series.size(); ++i) addSeries(picture.series[i], int(i));
    setLevel(*m_mark, picture.mark);
    m_markName->setVisible(picture.mark.has_value());
    m_markName->setText(picture.markName);
    if (picture.mark) m_markName->position->setCoords(0, *picture.mark);
    setStyle(m_style);
    setNumbersVisible(true);
    finish(otherAxes);
}

void ProofPlot::clear() {
    clearPoints();
    m_picture = {};
    x()->setLabel({});
    y()->setLabel({});
    setLevel(*m_mark, {});
    m_markName->setVisible(false);
    setNumbersVisible(false);
}

void ProofPlot::setNumbersVisible(bool visible) {
    for (QCPAxis* axis : {x(), y()}) axis->setTickLabels(visible);
}

void ProofPlot::addSeries(const ProofSeries& series, int index) {
    QCPGraph* graph = addCurve(x(), y());
    graph->setName(series.name);
    graph->setAdaptiveSampling(false);
    graph->addToLegend();
    for (const QPointF& point : series.at) graph->addData(point.x(), point.y());
    m_graphs.append(graph);
    for (qsizetype i = 0; i < series.labels.size(); ++i) {
        if (series.labels[i].isEmpty()) continue;
        // Two lines that fall to the right: words above the upper one, below the other.
        QCPItemText* label =
            addText(m_rect, QMargins(8, 3, 8, 3),
                    index % 2 == 1 ? Qt::AlignLeft | Qt::AlignBottom : Qt::AlignRight | Qt::AlignTop);
        label->setText(series.labels[i]);
        label->position->setCoords(series.at[i]);
        m_labels.append(label);
    }
}

// Puts words that would end beyond the axes on the other side of their point.
void ProofPlot::placeLabels() {
    const QRectF inside = m_rect->rect();
    for (QCPItemText* label : m_labels) {
        const Qt::Alignment upright = label->positionAlignment() & Qt::AlignVertical_Mask;
        const Qt::Alignment usual = upright == Qt::AlignBottom ? Qt::AlignLeft : Qt::AlignRight;
        const double at = label->position->pixelPosition().x();
        const QMargins padding = label->padding();
        const double width =
            QFontMetricsF(label->font()).horizontalAdvance(label->text()) + padding.left() + padding.right();
        const bool isOut = usual == Qt::AlignLeft ? at + width > inside.right() : at - width < inside.left();
        const Qt::Alignment other = usual == Qt::AlignLeft ? Qt::AlignRight : Qt::AlignLeft;
        label->setPositionAlignment((isOut ? other : usual) | upright);
    }
}

void ProofPlot::restyle() {
    for (qsizetype i = 0; i < m_graphs.size(); ++i) {
        const ProofSeries& series = m_picture.series[static_cast<std::size_t>(i)];
        const int index = static_cast<int>(i);
        const bool isJoined = series.points == ProofSeries::Points::joined;
        m_graphs[i]->setLineStyle(isJoined ? QCPGraph::lsLine : QCPGraph::lsNone);
        m_graphs[i]->setPen(m_style.linePen(index));
        m_graphs[i]->setScatterStyle(scatterOf(series.points, index, m_style));
    }
    m_mark->setPen(QPen(m_style.zeroLine, 1.5, Qt::DashLine));
}

void ProofPlot::setRanges() {
    QCPRange times = decadesOf(m_picture, &QPointF::x, {});
    QCPRange errors = decadesOf(m_picture, &QPointF::y, m_picture.mark);
    if (!m_labels.isEmpty()) {  // room for words, factors
        times.upper *= 12;
        errors.upper *= 4;
    }
    x()->setRange(times);
    y()->setRange(errors);
}

KeyPlaces ProofPlot::keyPlaces() const {
    KeyPlaces places;
    places.rect = m_rect;
    places.on = KeyPlaces::On::points;
    places.words = [this](QPointF place) {
        const std::optional<int> row = rowAt(pixelOf(place));
        return row ? m_nameOf(*row) : QString();
    };
    return places;
}

std::optional<int> ProofPlot::rowAt(QPointF pixel) const {
    constexpr double nearby = 10;  // [px]
    double least = nearby;
    std::optional<int> found;
    for (const ProofSeries& series : m_picture.series)
        for (qsizetype i = 0; i < series.at.size(); ++i) {
            const QPointF at = pixelOf(series.at[i]);
            const double distance = std::hypot(at.x() - pixel.x(), at.y() - pixel.y());
            if (distance > least) continue;
            least = distance;
            found = series.rows[i];
        }
    return found;
}

}  // namespace drillwave
