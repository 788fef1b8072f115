// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/curve_graph.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace drillwave {
namespace {

// Of a device pixel: what is nearer cannot be seen.
constexpr double sameColumn = 0.5;

bool isFinite(QPointF point) {
    return std::isfinite(point.x()) && std::isfinite(point.y());
}

// Points of one column of pixels, in their order.
class Column {
  public:
    void begin(qsizetype index) { m_kept.fill(index); }
    void add(const QVector<QPointF>& line, qsizetype index) {
        if (line[index].y() < line[m_kept[1]].y()) m_kept[1] = index;
        if (line[index].y() > line[m_kept[2]].y()) m_kept[2] = index;
        m_kept[3] = index;
    }
    void flush(const QVector<QPointF>& line, QVector<QPointF>& thinned) const {
        std::array<qsizetype, 4> order = m_kept;
        std::ranges::sort(order);
        const auto end = std::unique(order.begin(), order.end());
        for (auto index = order.begin(); index != end; ++index) thinned.append(line[*index]);
    }

  private:
    std::array<qsizetype, 4> m_kept{};  // first, lowest, highest, last
};

// As one path a line costs with its length: that of a noisy record is drawn piece by piece, in a small part
// of the time. In so dense a band neither the ends of the pieces nor dashes could be seen.
constexpr double longestPath = 20'000;  // [device pixels]

double lengthOf(const QVector<QPointF>& line) {
    double length = 0;
    for (qsizetype i = 1; i < line.size(); ++i) {
        const QPointF way = line[i] - line[i - 1];
        if (isFinite(way)) length += std::abs(way.x()) + std::abs(way.y());
    }
    return length;
}

void drawPieces(QCPPainter& painter, const QVector<QPointF>& line) {
    const QPen pen = painter.pen();
    painter.setPen(QPen(pen.brush(), pen.widthF(), Qt::SolidLine, Qt::SquareCap));
    for (qsizetype i = 1; i < line.size(); ++i)
        if (isFinite(line[i - 1]) && isFinite(line[i])) painter.drawLine(QLineF(line[i - 1], line[i]));
    painter.setPen(pen);
}

void drawLine(QCPPainter& painter, const QVector<QPointF>& line) {
    const double scale = std::max(1.0, painter.deviceTransform().m11());
    const bool isVector = painter.modes().testFlag(QCPPainter::pmVectorized);
    const QVector<QPointF> drawn = isVector ? line : thinnedLine(line, 1 / scale);
    if (!isVector && lengthOf(drawn) * scale > longestPath) return drawPieces(painter, drawn);
    qsizetype begin = 0;
    for (qsizetype i = 0; i <= drawn.size(); ++i) {
        if (i < drawn.size() && isFinite(drawn[i])) continue;
        painter.drawPolyline(drawn.constData() + begin, static_cast<int>(i - begin));
        begin = i + 1;
    }
}

}  // namespace

QVector<QPointF> thinnedLine(const QVector<QPointF>& line, double pixel) {
    QVector<QPointF> thinned;
    thinned.reserve(line.size());
    Column column;
    bool open = false;
    double left = 0;
    for (qsizetype i = 0; i < line.size(); ++i) {
        const QPointF point = line[i];
        if (isFinite(point) && open && std::abs(point.x() - left) < sameColumn * pixel) {
            column.add(line, i);
            continue;
        }
        if (open) column.flush(line, thinned);
        open = isFinite(point);
        if (!open) {
            thinned.append(point);
            continue;
        }
        left = point.x();
        column.begin(i);
    }
    if (open) column.flush(line, thinned);
    return thinned;
}

void CurveGraph::drawLinePlot(QCPPainter* painter, const QVector<QPointF>& lines) const {
    if (painter->pen().style() == Qt::NoPen || painter->pen().color().alpha() == 0) return;
    applyDefaultAntialiasingHint(painter);
    drawLine(*painter, lines);
}

void CurvePath::drawCurveLine(QCPPainter* painter, const QVector<QPointF>& lines) const {
    if (painter->pen().style() == Qt::NoPen || painter->pen().color().alpha() == 0) return;
    applyDefaultAntialiasingHint(painter);
    drawLine(*painter, lines);
}

CurveGraph* addCurve(QCPAxis* keyAxis, QCPAxis* valueAxis) {
    return new CurveGraph(keyAxis, valueAxis);  // the plot takes it over
}

}  // namespace drillwave
