// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/curve_clip.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace drillwave {
namespace {

constexpr double lineBreak = std::numeric_limits<double>::quiet_NaN();

// An axis range as 0 to 1 along which lines are straight.
class UnitScale {
  public:
    explicit UnitScale(const QCPAxis& axis)
        : m_logarithmic(axis.scaleType() == QCPAxis::stLogarithmic), m_range(axis.range()) {
        m_begin = straight(m_range.lower);
        m_size = straight(m_range.upper) - m_begin;
    }

    // A value that is not positive has no place on a logarithmic scale: it is far below.
    double share(double coordinate) const {
        if (m_logarithmic && coordinate <= 0) return -1e3;
        return (straight(coordinate) - m_begin) / m_size;
    }
    double coordinate(double share) const {
        if (share <= 0) return m_range.lower;
        if (share >= 1) return m_range.upper;
        const double place = m_begin + share * m_size;
        return m_logarithmic ? std::exp(place) : place;
    }

  private:
    double straight(double coordinate) const { return m_logarithmic ? std::log(coordinate) : coordinate; }

    bool m_logarithmic;
    QCPRange m_range;
    double m_begin;
    double m_size;
};

// Part of the way from a to b that is within 0 to 1, as shares of it (Liang and Barsky).
struct Inside {
    double begin = 0;
    double end = 1;

    void cut(double a, double b) {
        const double way = b - a;
        if (way == 0) {
            if (a < 0 || a > 1) end = -1;
            return;
        }
        const double low = -a / way;
        const double high = (1 - a) / way;
        begin = std::max(begin, std::min(low, high));
        end = std::min(end, std::max(low, high));
    }
};

bool isInside(QPointF point) {
    return point.x() >= 0 && point.x() <= 1 && point.y() >= 0 && point.y() <= 1;
}

}  // namespace

QVector<QCPGraphData> clippedLine(const QCPGraphDataContainer& points, const QCPAxis& keyAxis,
                                  const QCPAxis& valueAxis) {
    const UnitScale keys(keyAxis);
    const UnitScale values(valueAxis);
    const auto placeOf = [&](const QCPGraphData& point) {
        return QPointF(keys.share(point.key), values.share(point.value));
    };
    QVector<QCPGraphData> line;
    bool open = false;  // whether the line continues from its last point
    for (auto to = points.constBegin(); to != points.constEnd(); ++to) {
        if (to == points.constBegin()) continue;
        const QCPGraphData& from = *(to - 1);
        const QPointF a = placeOf(from);
        const QPointF b = placeOf(*to);
        Inside inside;
        inside.cut(a.x(), b.x());
        inside.cut(a.y(), b.y());
        if (!(inside.begin <= inside.end)) {
            open = false;
            continue;
        }
        const auto at = [&](double share) {
            const QPointF place = a + share * (b - a);
            return QCPGraphData(keys.coordinate(place.x()), values.coordinate(place.y()));
        };
        if (!open) {
            if (!line.isEmpty()) line.append(QCPGraphData(line.last().key, lineBreak));
            line.append(isInside(a) ? from : at(inside.begin));
        }
        line.append(isInside(b) ? *to : at(inside.end));
        open = isInside(b);
    }
    return line;
}

CurveClip::CurveClip(QCustomPlot& plot) {
    for (int i = 0; i < plot.graphCount(); ++i) {
        QCPGraph* graph = plot.graph(i);
        const QCPRange keys = graph->keyAxis()->range();
        const QCPRange values = graph->valueAxis()->range();
        const auto& points = *graph->data();
        const bool within = std::all_of(points.constBegin(), points.constEnd(), [&](const QCPGraphData& p) {
            return keys.contains(p.key) && values.contains(p.value);
        });
        if (within) continue;
        m_whole.append({graph, graph->data()});
        auto cut = QSharedPointer<QCPGraphDataContainer>::create();
        cut->set(clippedLine(points, *graph->keyAxis(), *graph->valueAxis()), true);
        graph->setData(cut);
    }
}

CurveClip::~CurveClip() {
    for (const Whole& whole : m_whole) whole.graph->setData(whole.data);
}

}  // namespace drillwave
