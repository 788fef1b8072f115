// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/curve_reading.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drillwave {
namespace {

constexpr double noReading = std::numeric_limits<double>::quiet_NaN();

using Point = QCPGraphDataContainer::const_iterator;

// Returns the first point after x.
Point pointBehind(const QCPGraphDataContainer& points, double x) {
    return std::upper_bound(points.constBegin(), points.constEnd(), x,
                            [](double key, const QCPGraphData& point) { return key < point.key; });
}

double between(const QCPGraphData& from, const QCPGraphData& to, double x) {
    const double share = (x - from.key) / (to.key - from.key);
    return from.value + share * (to.value - from.value);
}

// Neumaier's sum: a million chords lose no more digits than a few.
class Sum {
  public:
    void add(double term) {
        const double sum = m_sum + term;
        m_lost += std::abs(m_sum) >= std::abs(term) ? (m_sum - sum) + term : (term - sum) + m_sum;
        m_sum = sum;
    }
    double value() const { return m_sum + m_lost; }

  private:
    double m_sum = 0;
    double m_lost = 0;
};

double valueOf(const QCPGraphDataContainer& points, const CurveMeaning& meaning, double x) {
    return meaning.value ? meaning.value(x) : chordValue(points, x);
}

// Returns the part of the way from a to b with a curve, for the mean.
double coveredLength(const QCPGraphDataContainer& points, const CursorReading& ends) {
    if (std::isfinite(ends.yA) && std::isfinite(ends.yB)) return ends.b - ends.a;
    if (points.isEmpty()) return 0;
    const double first = points.constBegin()->key;
    const double last = (points.constEnd() - 1)->key;
    return std::clamp(ends.b, first, last) - std::clamp(ends.a, first, last);
}

}  // namespace

double chordValue(const QCPGraphDataContainer& points, double x) {
    const Point behind = pointBehind(points, x);
    if (behind == points.constBegin()) return noReading;
    const Point before = behind - 1;
    if (before->key == x) return before->value;
    return behind == points.constEnd() ? noReading : between(*before, *behind, x);
}

double chordIntegral(const QCPGraphDataContainer& points, double a, double b) {
    if (b < a) return -chordIntegral(points, b, a);
    if (points.size() < 2) return 0;
    Sum area;
    Point point = pointBehind(points, a);
    if (point == points.constBegin()) ++point;
    for (; point != points.constEnd() && (point - 1)->key < b; ++point) {
        const QCPGraphData& from = *(point - 1);
        const double left = std::max(a, from.key);
        const double right = std::min(b, point->key);
        if (right > left) area.add((right - left) * between(from, *point, left + (right - left) / 2));
    }
    return area.value();
}

CursorReading readCurve(const QCPGraphDataContainer& points, const CurveMeaning& meaning, double a,
                        double b) {
    CursorReading reading{
        a, b, valueOf(points, meaning, a), valueOf(points, meaning, b), noReading, noReading, noReading};
    const double area = meaning.integral ? meaning.integral(a, b) : chordIntegral(points, a, b);
    const double covered = coveredLength(points, reading);
    reading.integral = area * meaning.integralFactor;
    reading.mean = covered != 0 ? area / covered : reading.yA;
    if (a != b) reading.slope = (reading.yB - reading.yA) / (b - a) * meaning.slopeFactor;
    return reading;
}

}  // namespace drillwave
