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

// Shape, colour and filling differ: nothing by colour alone.
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

ProofPlot::ProofPlot(QCustomPlot* plot) : QObject(plot), m_plot(plot), m_view(new FittedView(this)) {
    plot->setAutoAddPlottableToLegend(false);
    plot->axisRect()->setupFullAxesBox(true);
    plot->axisRect()->setMinimumMargins(QMargins(4, 4, 14, 4));
    connect(plot, &QCustomPlot::afterLayout, this, &ProofPlot::placeLabels);
    for (QCPAxis* axis : {plot->xAxis, plot->yAxis}) {
        makeLogarithmic(*axis);
        m_view->watch(axis);
    }
    for (QCPAxis* axis : {plot->xAxis2, plot->yAxis2}) makeLogarithmic(*axis);
    plot->plotLayout()->insertRow(0);
    auto* header = new QCPLayoutGrid;
    plot->plotLayout()->addElement(0, 0, header);
    plot->plotLayout()->setRowStretchFactor(0, 1e-3);
    header->setRowSpacing(0);
    m_caption = new QCPTextElement(plot);
    m_caption->setTextFlags(Qt::AlignLeft | Qt::AlignVCenter);
    m_caption->setMargins(QMargins(7, 0, 0, 4));
    plot->legend->setVisible(true);
    plot->legend->setMargins(QMargins(7, 6, 0, 0));
    plot->legend->setFillOrder(QCPLayoutGrid::foColumnsFirst);
    plot->legend->setWrap(4);
    header->addElement(0, 0, plot->legend);
    header->addElement(1, 0, m_caption);
    // Takes what width is left: a legend without entries would keep the axes as narrow as itself.
    header->addElement(0, 1, new QCPTextElement(plot));
    m_mark = new QCPItemStraightLine(plot);
    m_mark->setSelectable(false);
    m_mark->setClipAxisRect(plot->axisRect());
    m_markName = new QCPItemText(plot);
    m_markName->setSelectable(false);
    m_markName->setClipAxisRect(plot->axisRect());
    m_markName->setPadding(QMargins(6, 2, 6, 2));
    m_markName->setPositionAlignment(Qt::AlignLeft | Qt::AlignBottom);
    for (QCPItemPosition* position :
         {m_mark->point1, m_mark->point2, static_cast<QCPItemPosition*>(m_markName->position)}) {
        position->setAxisRect(plot->axisRect());
        position->setAxes(plot->xAxis, plot->yAxis);
        position->setTypeX(QCPItemPosition::ptAxisRectRatio);
        position->setTypeY(QCPItemPosition::ptPlotCoords);
    }
    m_mark->setVisible(false);
    m_markName->setVisible(false);
    m_message = new PlotMessage(plot);
    setStyle(PlotStyle::forPaper());
}

void ProofPlot::clear() {
    for (QCPGraph* graph : m_graphs) m_plot->removeGraph(graph);
    for (QCPItemText* label : m_labels) m_plot->removeItem(label);
    m_graphs.clear();
    m_labels.clear();
}

void ProofPlot::present(const ProofPicture& picture) {
    const bool otherAxes = m_picture.xLabel != picture.xLabel;
    clear();
    m_picture = picture;
    m_message->hide();
    m_plot->xAxis->setLabel(picture.xLabel);
    m_plot->yAxis->setLabel(picture.yLabel);
    m_caption->setText(picture.caption);
    for (std::size_t i = 0; i < picture.series.size(); ++i) addSeries(picture.series[i], int(i));
    m_mark->setVisible(picture.mark.has_value());
    m_markName->setVisible(picture.mark.has_value());
    if (picture.mark) {
        m_mark->point1->setCoords(0, *picture.mark);
        m_mark->point2->setCoords(1, *picture.mark);
        m_markName->position->setCoords(0, *picture.mark);
        m_markName->setText(picture.markName);
    }
    applyStyle();
    setNumbersVisible(true);
    if (m_view->isFitted() || otherAxes) fit();
}

void ProofPlot::showNothing(const QString& message) {
    clear();
    m_picture = {};
    m_caption->setText({});
    m_plot->xAxis->setLabel({});
    m_plot->yAxis->setLabel({});
    m_mark->setVisible(false);
    m_markName->setVisible(false);
    m_message->show(message);
    setNumbersVisible(false);
}

void ProofPlot::setNumbersVisible(bool visible) {
    for (QCPAxis* axis : {m_plot->xAxis, m_plot->yAxis}) axis->setTickLabels(visible);
}

void ProofPlot::addSeries(const ProofSeries& series, int index) {
    QCPGraph* graph = addCurve(m_plot->xAxis, m_plot->yAxis);
    graph->setName(series.name);
    graph->setAdaptiveSampling(false);
    graph->addToLegend();
    for (const QPointF& point : series.at) graph->addData(point.x(), point.y());
    m_graphs.append(graph);
    for (qsizetype i = 0; i < series.labels.size(); ++i) {
        if (series.labels[i].isEmpty()) continue;
        auto* label = new QCPItemText(m_plot);
        label->setSelectable(false);
        label->setClipAxisRect(m_plot->axisRect());
        label->setText(series.labels[i]);
        label->setPadding(QMargins(8, 3, 8, 3));
        // Two lines that fall to the right: words above the upper one, below the other.
        label->setPositionAlignment(index % 2 == 1 ? Qt::AlignLeft | Qt::AlignBottom
                                                   : Qt::AlignRight | Qt::AlignTop);
        label->position->setCoords(series.at[i]);
        m_labels.append(label);
    }
}

// Words that would end beyond the axes stand on the other side of their point.
void ProofPlot::placeLabels() {
    const QRectF inside = m_plot->axisRect()->rect();
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

void ProofPlot::setStyle(const PlotStyle& style) {
    m_style = style;
    m_message->setStyle(style);
    m_plot->setBackground(style.background);
    style.applyTo(*m_plot->axisRect());
    style.applyTo(*m_caption);
    applyStyle();
}

void ProofPlot::applyStyle() {
    m_style.applyTo(*m_plot->legend);
    for (qsizetype i = 0; i < m_graphs.size(); ++i) {
        const ProofSeries& series = m_picture.series[static_cast<std::size_t>(i)];
        const int index = static_cast<int>(i);
        const bool isJoined = series.points == ProofSeries::Points::joined;
        m_graphs[i]->setLineStyle(isJoined ? QCPGraph::lsLine : QCPGraph::lsNone);
        m_graphs[i]->setPen(m_style.linePen(index));
        m_graphs[i]->setScatterStyle(scatterOf(series.points, index, m_style));
    }
    for (QCPItemText* label : m_labels) {
        label->setFont(m_style.font);
        label->setColor(m_style.text);
    }
    m_mark->setPen(QPen(m_style.zeroLine, 1.5, Qt::DashLine));
    m_markName->setFont(m_style.font);
    m_markName->setColor(m_style.text);
}

void ProofPlot::fit() {
    m_view->fit([&] {
        QCPRange times = decadesOf(m_picture, &QPointF::x, {});
        QCPRange errors = decadesOf(m_picture, &QPointF::y, m_picture.mark);
        if (!m_labels.isEmpty()) {  // room for words, factors
            times.upper *= 12;
            errors.upper *= 4;
        }
        m_plot->xAxis->setRange(times);
        m_plot->yAxis->setRange(errors);
    });
}

KeyPlaces ProofPlot::keyPlaces(std::function<QString(int)> nameOf) const {
    KeyPlaces places;
    places.rect = m_plot->axisRect();
    places.on = KeyPlaces::On::points;
    places.words = [this, nameOf = std::move(nameOf)](QPointF place) {
        const std::optional<int> row =
            rowAt({m_plot->xAxis->coordToPixel(place.x()), m_plot->yAxis->coordToPixel(place.y())});
        return row ? nameOf(*row) : QString();
    };
    return places;
}

std::optional<int> ProofPlot::rowAt(QPointF pixel) const {
    constexpr double nearby = 10;  // [px]
    double least = nearby;
    std::optional<int> found;
    for (const ProofSeries& series : m_picture.series)
        for (qsizetype i = 0; i < series.at.size(); ++i) {
            const QPointF at(m_plot->xAxis->coordToPixel(series.at[i].x()),
                             m_plot->yAxis->coordToPixel(series.at[i].y()));
            const double distance = std::hypot(at.x() - pixel.x(), at.y() - pixel.y());
            if (distance > least) continue;
            least = distance;
            found = series.rows[i];
        }
    return found;
}

}  // namespace drillwave
