// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/curve_graph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace drillwave {
namespace {

// Width of a column in device pixels: closer points cannot be seen apart.
constexpr double sameColumn = 0.5;

bool isFinite(QPointF point) {
    return std::isfinite(point.x()) && std::isfinite(point.y());
}

// Points of one column of pixels, in their order.
class PixelColumn {
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

// Largest distance of a line from a point of it, in device pixels.
constexpr double sameLine = 0.05;

// Leaves out the points of a line that run straight on, as far as a line through the last that stays passes
// all of them within `tolerance`: a stroke costs with its points.
class Straightener {
  public:
    Straightener(double tolerance, QVector<QPointF>& straight)
        : m_tolerance(tolerance), m_straight(straight) {}

    void add(QPointF point) {
        if (!isFinite(point) || m_straight.isEmpty() || !isFinite(m_last)) return keep(point);
        const double slope = (point.y() - m_straight.last().y()) / (point.x() - m_straight.last().x());
        if (point.x() <= m_last.x() || slope < m_lowest || slope > m_highest) restart();
        follow(point);
    }
    void finish() { restart(); }

  private:
    void keep(QPointF point) {
        restart();
        m_straight.append(point);
        m_last = point;
    }
    // Restarts from the last point, which stays.
    void restart() {
        if (!m_straight.isEmpty() && isFinite(m_last) && m_straight.last() != m_last)
            m_straight.append(m_last);
        m_lowest = -std::numeric_limits<double>::infinity();
        m_highest = std::numeric_limits<double>::infinity();
    }
    void follow(QPointF point) {
        const QPointF from = m_straight.last();
        const double way = point.x() - from.x();
        m_last = point;
        if (way <= 0) return m_straight.append(point);
        m_lowest = std::max(m_lowest, (point.y() - m_tolerance - from.y()) / way);
        m_highest = std::min(m_highest, (point.y() + m_tolerance - from.y()) / way);
    }

    double m_tolerance;
    QVector<QPointF>& m_straight;
    QPointF m_last{std::nan(""), 0};
    double m_lowest = 0, m_highest = 0;  // slopes from the last point that stays
};

QVector<QPointF> straightened(const QVector<QPointF>& line, double tolerance) {
    QVector<QPointF> straight;
    straight.reserve(line.size());
    Straightener straightener(tolerance, straight);
    for (const QPointF& point : line) straightener.add(point);
    straightener.finish();
    return straight;
}

// The cost of a line as one path grows with its length: a noisy record is drawn piece by piece, in a small
// part of the time. In so dense a band neither the ends of the pieces nor dashes could be seen.
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
    PixelColumn column;
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
    return straightened(thinned, sameLine * pixel);
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
