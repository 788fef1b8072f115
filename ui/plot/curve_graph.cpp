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

void drawLine(QCPPainter& painter, const QVector<QPointF>& line) {
    const QVector<QPointF> drawn =
        painter.modes().testFlag(QCPPainter::pmVectorized)
            ? line
            : thinnedLine(line, 1 / std::max(1.0, painter.deviceTransform().m11()));
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
