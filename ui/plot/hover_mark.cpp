// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/hover_mark.h"

#include <algorithm>
#include <cmath>

#include "ui/plot/curve_names.h"
#include "ui/plot/legend_entries.h"
#include "ui/text/number_text.h"

namespace drillwave {
namespace {

constexpr qsizetype mostSegments = 2000;  // looked at for one pointer position

// Returns the share of the line from a to b, 0 to 1, that is nearest to p; all in pixels.
double nearestShare(QPointF a, QPointF b, QPointF p) {
    const QPointF along = b - a;
    const double square = QPointF::dotProduct(along, along);
    return square > 0 ? std::clamp(QPointF::dotProduct(p - a, along) / square, 0.0, 1.0) : 0;
}

// The nearest point so far.
struct Search {
    QPointF pointer;
    double distance;  // what is farther away does not count
    std::optional<CurvePoint> found;

    void look(QCPAbstractPlottable& curve, QPointF from, QPointF to) {
        const QPointF a = curve.coordsToPixels(from.x(), from.y());
        const QPointF b = curve.coordsToPixels(to.x(), to.y());
        const double share = nearestShare(a, b, pointer);
        const QPointF pixel = a + share * (b - a);
        const double away = std::hypot(pixel.x() - pointer.x(), pixel.y() - pointer.y());
        if (!(away < distance)) return;
        distance = away;
        // Through the pixel, so that it is right on logarithmic axes as well.
        const double x = share == 0   ? from.x()
                         : share == 1 ? to.x()
                                      : curve.keyAxis()->pixelToCoord(pixel.x());
        const double y = share == 0   ? from.y()
                         : share == 1 ? to.y()
                                      : curve.valueAxis()->pixelToCoord(pixel.y());
        found = CurvePoint{&curve, x, y, pixel};
    }
};

template <class Iterator, class Coordinates>
void lookAlong(Search& search, QCPAbstractPlottable& curve, Iterator begin, Iterator end,
               const Coordinates& at) {
    const qsizetype stride = std::max<qsizetype>(1, (end - begin) / mostSegments);
    for (Iterator point = begin; end - point > 1;) {
        const Iterator next = point + std::min<qsizetype>(stride, end - point - 1);
        search.look(curve, at(*point), at(*next));
        point = next;
    }
}

void lookAtGraph(Search& search, QCPGraph& graph) {
    const QCPAxis& keys = *graph.keyAxis();
    const auto& points = *graph.data();
    const double left = keys.pixelToCoord(search.pointer.x() - search.distance);
    const double right = keys.pixelToCoord(search.pointer.x() + search.distance);
    lookAlong(search, graph, points.findBegin(left), points.findEnd(right),
              [](const QCPGraphData& point) { return QPointF(point.key, point.value); });
}

void lookAtPath(Search& search, QCPCurve& path) {
    const auto& points = *path.data();
    lookAlong(search, path, points.constBegin(), points.constEnd(),
              [](const QCPCurveData& point) { return QPointF(point.key, point.value); });
}

}  // namespace

std::optional<CurvePoint> nearestCurvePoint(const QCustomPlot& plot, QPointF pixel, double tolerance) {
    const QCPAxisRect* rect = plot.axisRectAt(pixel);
    if (!rect || !rect->rect().contains(pixel.toPoint())) return std::nullopt;
    Search search{pixel, tolerance, std::nullopt};
    for (QCPAbstractPlottable* curve : visibleCurves(plot)) {
        if (curve->keyAxis()->axisRect() != rect) continue;
        if (auto* graph = qobject_cast<QCPGraph*>(curve)) lookAtGraph(search, *graph);
        if (auto* path = qobject_cast<QCPCurve*>(curve)) lookAtPath(search, *path);
    }
    return search.found;
}

bool isOnCurve(const QCustomPlot& plot, QPointF pixel, double reach) {
    const QCPAxisRect* rect = plot.axisRectAt(pixel);
    if (!rect || !rect->rect().contains(pixel.toPoint())) return false;
    Search search{pixel, reach, std::nullopt};
    for (QCPAbstractPlottable* curve : rect->plottables()) {
        if (!curve->realVisibility()) continue;
        auto* graph = qobject_cast<QCPGraph*>(curve);
        if (graph && graph->lineStyle() == QCPGraph::lsNone)
            for (const QCPGraphData& point : *graph->data())
                search.look(*graph, {point.key, point.value}, {point.key, point.value});
        else if (graph)
            lookAtGraph(search, *graph);
        else if (auto* path = qobject_cast<QCPCurve*>(curve))
            lookAtPath(search, *path);
    }
    return search.found.has_value();
}

QString pointText(const CurvePoint& point, const CurveMeaning& meaning, const QLocale& locale) {
    const auto quantity = [&locale](double value, const QString& unit) {
        const QString number = numberText(value, 6, locale);
        return unit.isEmpty() ? number : number + QChar(QChar::Nbsp) + unit;
    };
    const auto line = [&](const QString& name, const QString& value) {
        return QStringLiteral("\n%1 = %2").arg(name, value);
    };
    const QString word = meaning.wordAt(point.x);
    return point.curve->name() +
           (word.isEmpty() ? line(xNameOf(*point.curve, meaning), quantity(point.x, meaning.xUnit))
                           : QLatin1Char('\n') + word) +
           line(yNameOf(*point.curve, meaning), quantity(point.y, meaning.yUnit));
}

void HoverMark::addItems() {
    m_ring = new QCPItemTracer(&m_plot);
    m_ring->setLayer(QStringLiteral("overlay"));
    m_ring->setSelectable(false);
    m_ring->setStyle(QCPItemTracer::tsCircle);
    m_ring->setSize(8);
    m_ring->position->setType(QCPItemPosition::ptAbsolute);
    m_label = new QCPItemText(&m_plot);
    m_label->setLayer(QStringLiteral("overlay"));
    m_label->setSelectable(false);
    m_label->setPadding(QMargins(5, 3, 5, 3));
    m_label->setTextAlignment(Qt::AlignLeft);
    m_label->position->setType(QCPItemPosition::ptAbsolute);
    m_label->setClipToAxisRect(false);
    setStyle(m_style);
}

bool HoverMark::hide() {
    const bool changed = m_ring && m_ring->visible();
    if (changed) m_ring->setVisible(false);
    if (m_label) m_label->setVisible(false);
    return changed;
}

void HoverMark::show(QCPAxisRect& rect, QPointF pixel, const QString& text) {
    if (!m_ring || !m_label) addItems();
    m_ring->setClipAxisRect(&rect);
    m_ring->position->setCoords(pixel);
    m_ring->setVisible(true);
    m_label->setText(text);
    // The text is away from the pointer, towards the middle of the plot, so that it is never cut off.
    const bool left = pixel.x() > rect.center().x();
    const bool above = pixel.y() > m_plot.viewport().top() + 60;
    m_label->setPositionAlignment((left ? Qt::AlignRight : Qt::AlignLeft) |
                                  (above ? Qt::AlignBottom : Qt::AlignTop));
    m_label->position->setCoords(pixel + QPointF(left ? -10 : 10, above ? -8 : 12));
    m_label->setVisible(!text.isEmpty());
}

void HoverMark::setStyle(const PlotStyle& style) {
    m_style = style;
    if (!m_ring || !m_label) return;
    m_ring->setPen(QPen(style.text, 1.6));
    m_ring->setBrush(style.background);
    m_label->setFont(style.font);
    m_label->setColor(style.text);
    m_label->setPen(QPen(style.frame, 1));
    m_label->setBrush(style.background);
}

QString HoverMark::text() const {
    return m_label && m_label->visible() ? m_label->text() : QString();
}

}  // namespace drillwave
