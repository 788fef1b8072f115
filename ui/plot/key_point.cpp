// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/key_point.h"

#include <algorithm>
#include <cmath>

#include "ui/plot/curve_reading.h"
#include "ui/plot/legend_entries.h"
#include "ui/plot/plot_widget.h"

namespace drillwave {
namespace {

constexpr double samePlace = 0.5;  // [px]

bool isLeftOf(QPointF a, QPointF b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
}

bool isBelow(QPointF a, QPointF b) {
    return a.y() != b.y() ? a.y() < b.y() : a.x() < b.x();
}

// The value at x, or, where the curve has none there, that of its nearest point.
std::optional<QPointF> pointOf(const QCPGraph& curve, double x) {
    const double value = chordValue(*curve.data(), x);
    if (std::isfinite(value)) return QPointF(x, value);
    std::optional<QPointF> nearest;
    for (const QCPGraphData& point : *curve.data())
        if (std::isfinite(point.value) && (!nearest || std::abs(point.key - x) < std::abs(nearest->x() - x)))
            nearest = QPointF(point.key, point.value);
    return nearest;
}

}  // namespace

KeyPoint::KeyPoint(PlotWidget& plot) : QObject(&plot), m_plot(plot), m_mark(plot) {
    connect(&plot, &QCustomPlot::afterReplot, this, &KeyPoint::follow);
}

void KeyPoint::offer(KeyPlaces places) {
    m_places = std::move(places);
    leave();
}

QPointF KeyPoint::toPixel(QPointF place) const {
    return {m_places.rect->axis(QCPAxis::atBottom)->coordToPixel(place.x()),
            m_places.rect->axis(QCPAxis::atLeft)->coordToPixel(place.y())};
}

QPointF KeyPoint::toPlace(QPointF pixel) const {
    return {m_places.rect->axis(QCPAxis::atBottom)->pixelToCoord(pixel.x()),
            m_places.rect->axis(QCPAxis::atLeft)->pixelToCoord(pixel.y())};
}

std::optional<QPointF> KeyPoint::pixel() const {
    return m_place ? std::optional(toPixel(*m_place)) : std::nullopt;
}

// Includes the frame.
bool KeyPoint::isInView(QPointF place) const {
    return QRectF(m_places.rect->rect()).adjusted(-1, -1, 1, 1).contains(toPixel(place));
}

QList<QCPGraph*> KeyPoint::curves() const {
    QList<QCPGraph*> found;
    for (QCPAbstractPlottable* curve : visibleCurves(m_plot)) {
        auto* graph = qobject_cast<QCPGraph*>(curve);
        if (graph && graph->keyAxis()->axisRect() == m_places.rect) found.append(graph);
    }
    return found;
}

// Returns the points of all curves that are in view, each place once.
QVector<QPointF> KeyPoint::points(Qt::Orientation along) const {
    QVector<QPointF> found;
    for (const QCPGraph* curve : curves())
        for (const QCPGraphData& point : *curve->data())
            if (isInView({point.key, point.value})) found.append({point.key, point.value});
    std::ranges::sort(found, along == Qt::Horizontal ? &isLeftOf : &isBelow);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

// Returns the ends of the part of a curve that is in view, in keys; those of all of it if none is.
std::pair<double, double> KeyPoint::ends(const QCPGraph& curve) const {
    const QCPRange view = m_places.rect->axis(QCPAxis::atBottom)->range();
    const double first = curve.data()->constBegin()->key;
    const double last = (curve.data()->constEnd() - 1)->key;
    if (last < view.lower || first > view.upper) return {first, last};
    return {std::max(first, view.lower), std::min(last, view.upper)};
}

void KeyPoint::enter() {
    if (!isOffered() || m_place) return;
    const QPointF middle = toPlace(QRectF(m_places.rect->rect()).center());
    const std::optional<QPointF> wanted = m_places.start();
    const QPointF start = wanted && isInView(*wanted) ? *wanted : middle;
    if (m_places.on == KeyPlaces::On::area) return put(start);
    putOnNearest(start);
}

void KeyPoint::leave() {
    m_place.reset();
    m_curve = nullptr;
    show();
}

// Puts it on the curve nearest to a place, or on a point of one.
bool KeyPoint::putOnNearest(QPointF place) {
    if (m_places.on == KeyPlaces::On::points) {
        const QVector<QPointF> all = points(Qt::Horizontal);
        const auto distance = [&](QPointF point) {
            const QPointF away = toPixel(point) - toPixel(place);
            return std::hypot(away.x(), away.y());
        };
        const auto nearest = std::ranges::min_element(all, {}, distance);
        if (nearest != all.end()) put(*nearest);
        return nearest != all.end();
    }
    QCPGraph* nearest = nullptr;
    double least = HUGE_VAL;
    for (QCPGraph* curve : curves()) {
        const std::optional<QPointF> point = pointOf(*curve, place.x());
        const double away = point ? std::abs(toPixel(*point).y() - toPixel(place).y()) : HUGE_VAL;
        if (!(away < least)) continue;
        least = away;
        nearest = curve;
    }
    return nearest && putOn(nearest, place.x());
}

bool KeyPoint::putOn(QCPGraph* curve, double x) {
    const auto [first, last] = ends(*curve);
    const std::optional<QPointF> point = pointOf(*curve, std::clamp(x, first, last));
    if (!point) return false;
    m_curve = curve;
    put(*point);
    return true;
}

void KeyPoint::put(QPointF place) {
    m_place = place;
    show();
}

void KeyPoint::move(int right, int up) {
    if (!m_place) return;
    if (m_places.on == KeyPlaces::On::points)
        return putAtPoint(points(right != 0 ? Qt::Horizontal : Qt::Vertical), right + up);
    const QRectF view = m_places.rect->rect();
    const QPointF wanted = toPixel(*m_place) + QPointF(right, -up);
    const QPointF kept(std::clamp(wanted.x(), view.left(), view.right()),
                       std::clamp(wanted.y(), view.top(), view.bottom()));
    // A coordinate that does not move keeps all its digits.
    const QPointF there = toPlace(kept);
    if (m_places.on == KeyPlaces::On::area)
        return put({right != 0 ? there.x() : m_place->x(), up != 0 ? there.y() : m_place->y()});
    if (up != 0)
        changeCurve(up > 0);
    else if (QCPGraph* curve = curveHere())
        putOn(curve, there.x());
}

// Along points in some order, from where it is.
void KeyPoint::putAtPoint(const QVector<QPointF>& sorted, qsizetype steps) {
    if (sorted.isEmpty()) return;
    const qsizetype here = sorted.indexOf(*m_place);
    if (here < 0)
        putOnNearest(*m_place);
    else
        put(sorted[std::clamp<qsizetype>(here + steps, 0, sorted.size() - 1)]);
}

// Curves that lie on each other come one after the other, in their order in the legend.
void KeyPoint::changeCurve(bool up) {
    struct Height {
        double pixel;
        QCPGraph* curve;
    };
    QVector<Height> heights;
    for (QCPGraph* curve : curves())
        if (const double value = chordValue(*curve->data(), m_place->x()); std::isfinite(value))
            heights.append({toPixel({m_place->x(), value}).y(), curve});
    std::ranges::stable_sort(heights, std::ranges::less(), &Height::pixel);
    const auto here = std::ranges::find(heights, curveHere(), &Height::curve);
    if (here == heights.end()) return;
    const qsizetype next = (here - heights.begin()) + (up ? -1 : 1);
    if (next >= 0 && next < heights.size()) putOn(heights[next].curve, m_place->x());
}

void KeyPoint::goToEnd(bool last) {
    if (!m_place) return;
    if (m_places.on == KeyPlaces::On::points) {
        const QVector<QPointF> all = points(Qt::Horizontal);
        if (!all.isEmpty()) put(last ? all.last() : all.first());
    } else if (m_places.on == KeyPlaces::On::area) {
        const QRectF view = m_places.rect->rect();
        put({toPlace({last ? view.right() : view.left(), 0}).x(), m_place->y()});
    } else if (QCPGraph* curve = curveHere()) {
        const auto [from, to] = ends(*curve);
        putOn(curve, last ? to : from);
    }
}

bool KeyPoint::goToMark(bool forward) {
    if (!m_place) return false;
    QVector<QPointF> marks = m_places.marks();
    marks.removeIf([this](QPointF mark) { return !isInView(mark); });
    if (marks.isEmpty()) return false;
    std::ranges::sort(marks, &isLeftOf);
    const auto isAhead = [&](QPointF mark) {
        const QPointF away = toPixel(mark) - toPixel(*m_place);
        if (std::hypot(away.x(), away.y()) < samePlace) return false;
        return forward ? isLeftOf(*m_place, mark) : isLeftOf(mark, *m_place);
    };
    QPointF next = forward ? marks.first() : marks.last();
    if (!forward) std::ranges::reverse(marks);
    if (const auto ahead = std::ranges::find_if(marks, isAhead); ahead != marks.end()) next = *ahead;
    if (m_places.on == KeyPlaces::On::curves) putOnNearest(next);
    put(next);
    return true;
}

bool KeyPoint::isOnMark(QPointF pixel, double reach) const {
    if (!m_places.rect || !m_places.rect->rect().contains(pixel.toPoint())) return false;
    const QVector<QPointF> all = m_places.marks() + m_places.targets();
    return std::ranges::any_of(all, [&](QPointF mark) {
        const QPointF away = toPixel(mark) - pixel;
        return std::hypot(away.x(), away.y()) <= reach;
    });
}

void KeyPoint::take(Qt::KeyboardModifiers modifiers) {
    if (!m_place) return;
    const QPointF place = *m_place;
    emit m_plot.clicked(m_places.rect, place, modifiers);
    emit m_plot.placeTaken(m_places.rect, place, modifiers);
}

// The one it is on, which may be gone or hidden by now.
QCPGraph* KeyPoint::curveHere() const {
    if (m_places.on == KeyPlaces::On::curves)
        return curves().contains(m_curve.data()) ? m_curve.data() : nullptr;
    if (m_places.on == KeyPlaces::On::area) return nullptr;
    const auto isHere = [this](const QCPGraphData& point) {
        return QPointF(point.key, point.value) == *m_place;
    };
    for (QCPGraph* curve : curves())
        if (std::ranges::any_of(*curve->data(), isHere)) return curve;
    return nullptr;
}

// Follows other data.
void KeyPoint::follow() {
    if (!m_place) return;
    if (m_places.on == KeyPlaces::On::curves) {
        QCPGraph* curve = curveHere();
        if (const auto there = curve ? pointOf(*curve, m_place->x()) : std::nullopt)
            m_place = *there;
        else if (!putOnNearest(*m_place))
            return leave();
    }
    if (m_places.on == KeyPlaces::On::points && !points(Qt::Horizontal).contains(*m_place) &&
        !putOnNearest(*m_place))
        return leave();
    show();
}

QString KeyPoint::words() const {
    QStringList lines{m_places.words(*m_place)};
    if (QCPGraph* curve = curveHere())
        lines << m_plot.words({curve, m_place->x(), m_place->y(), toPixel(*m_place)});
    lines.removeAll(QString());
    return lines.join(QLatin1Char('\n'));
}

void KeyPoint::show() {
    if (m_place && !m_hidden)
        m_mark.show(*m_places.rect, *m_place, words());
    else
        m_mark.hide();
}

void KeyPoint::setHidden(bool hidden) {
    m_hidden = hidden;
    show();
}

}  // namespace drillwave
