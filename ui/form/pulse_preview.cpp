// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/pulse_preview.h"

#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "core/model/pulse_force.h"
#include "core/model/scales.h"
#include "ui/plot/plot_style.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"
#include "ui/text/shown_units.h"
#include "ui/text/unit_choice.h"

namespace drillwave {

namespace {

constexpr int curvedSteps = 40;
constexpr std::size_t mostSegments = 1000;  // segments drawn one by one

void append(QPolygonF& points, const PulseSegment& segment, double end, double peak) {
    const double length = std::min(segment.length, end - segment.start);
    const int steps = segment.kind == PulseSegment::Kind::linear ? 1 : curvedSteps;
    for (int i = 0; i <= steps; ++i) {
        const double x = length * i / steps;
        points.append({segment.start + x, segment.forceAt(x) / peak});
    }
}

// Keeps the lowest and the highest point of each bunch if several points fall on one pixel.
QPolygonF thinned(const QPolygonF& points) {
    const qsizetype bunch = points.size() / static_cast<qsizetype>(mostSegments) + 1;
    if (bunch <= 2) return points;
    QPolygonF kept;
    for (qsizetype i = 0; i < points.size(); i += bunch) {
        const auto begin = points.begin() + i;
        const auto end = points.begin() + std::min(i + bunch, points.size());
        auto [low, high] =
            std::minmax_element(begin, end, [](const QPointF& a, const QPointF& b) { return a.y() < b.y(); });
        if (low > high) std::swap(low, high);
        kept.append(*low);
        kept.append(*high);
    }
    return kept;
}

constexpr int digits = 3;
constexpr int gap = 4;  // between the frame, the labels and the curve [px]

}  // namespace

PulseCurve::PulseCurve(const PulseForce& force) {
    if (force.segments.empty()) return;
    end = visibleForceEnd(force);
    for (const PulseSegment& segment : force.segments)
        if (segment.start < end) append(points, segment, end, force.peak);
    points = thinned(points);
}

PulsePreview::PulsePreview(const UnitChoice& units, QWidget* parent) : QWidget(parent), m_units(units) {
    setObjectName(QStringLiteral("pulsePreview"));
    setAccessibleName(tr("Hammer force over time"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

// Uses a unit that suits the peak, which may be far from the mean force that sets other units.
QString PulsePreview::peakText(double peak, const Scenario& scenario) const {
    if (naturalUnits(scenario) == UnitSystem::si)
        return m_units.text(peak * scalesOf(scenario).force, UnitKind::force);
    const QString unit = QStringLiteral("F₀");
    return peak == 1 ? unit : numberText(peak, digits, QLocale()) + QChar(QChar::Nbsp) + unit;
}

void PulsePreview::present(const Scenario& scenario) {
    const PulseForce force = pulseForceOf(scenario);
    const PulseCurve curve(force);
    m_curve = curve.points;
    m_end = curve.end;
    const bool si = naturalUnits(scenario) == UnitSystem::si;
    const QString duration =
        si ? m_units.text(scalesOf(scenario).time, UnitKind::time) : QStringLiteral("t₀");
    const QString peak = peakText(force.peak, scenario);
    m_peakText = tr("peak %1").arg(peak);
    m_timeText = si ? tr("t₀ = %1").arg(duration) : duration;
    m_words = m_curve.isEmpty() ? tr("No hammer force: the rod arrives with a uniform velocity")
                                : tr("%1, %2, %3").arg(shapeText(scenario.pulse.shape), duration, peak);
    setAccessibleDescription(m_words);
    setToolTip(m_curve.isEmpty() ? m_words : tr("Force of the hammer on the rod over time: %1").arg(m_words));
    update();
}

QSize PulsePreview::sizeHint() const {
    return {200, 5 * fontMetrics().height() + 4 * gap};
}

QSize PulsePreview::minimumSizeHint() const {
    return {120, sizeHint().height()};
}

void PulsePreview::paintEvent(QPaintEvent* /*event*/) {
    const PlotStyle style = PlotStyle::forScreen(palette(), font());
    QPainter painter(this);
    painter.fillRect(rect(), style.background);
    painter.setPen(style.frame);
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    painter.setFont(style.font);
    painter.setPen(style.text);
    const QRect inside = rect().adjusted(2 * gap, gap, -2 * gap, -gap);
    if (m_curve.isEmpty()) {
        painter.drawText(inside, Qt::AlignCenter | Qt::TextWordWrap, m_words);
        return;
    }
    const int line = painter.fontMetrics().height();
    const QRectF area = QRectF(inside).adjusted(0.5, line + gap + 0.5, -0.5, -line - gap - 0.5);
    const auto at = [&](const QPointF& point) {
        return QPointF(area.left() + point.x() / m_end * area.width(),
                       area.bottom() - point.y() * area.height());
    };
    // The level of the peak and the end of t0, with their values.
    painter.drawText(inside, Qt::AlignLeft | Qt::AlignTop, m_peakText);
    const double t0 = at({1, 0}).x();
    const int width = painter.fontMetrics().horizontalAdvance(m_timeText);
    const int left = qBound(inside.left(), qRound(t0) - width / 2, inside.right() + 1 - width);
    painter.drawText(QRect(left, inside.top(), width + 1, inside.height()), Qt::AlignLeft | Qt::AlignBottom,
                     m_timeText);
    painter.setPen(QPen(style.zeroLine, 1, Qt::DotLine));
    painter.drawLine(area.topLeft(), area.topRight());
    painter.setPen(QPen(style.frame, 1));
    painter.drawLine(area.bottomLeft(), area.bottomRight());
    painter.drawLine(QPointF(t0, area.bottom()), QPointF(t0, area.bottom() + gap));

    painter.setRenderHint(QPainter::Antialiasing);
    QPolygonF curve;
    curve.append(area.bottomLeft());
    for (const QPointF& point : m_curve) curve.append(at(point));
    curve.append({curve.last().x(), area.bottom()});
    painter.setPen(Qt::NoPen);
    painter.setBrush(style.areaBrush(0));
    painter.drawPolygon(curve);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(style.linePen(0));
    painter.drawPolyline(curve);
}

QString shapeText(PulseShape shape) {
    return coreName(name(shape));
}

}  // namespace drillwave
