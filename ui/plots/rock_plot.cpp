#include "ui/plots/rock_plot.h"

#include <QVector>
#include <algorithm>
#include <cmath>

#include "core/wave/wave_field.h"

namespace drillwave {

RockCurve rockCurve(const Impact& impact, const Groups& groups, const ShownUnits& units) {
    const SampledHistory history = sampleHistory(impact);
    QVector<QCPCurveData> points{QCPCurveData(0, 0, 0)};
    points.reserve(static_cast<qsizetype>(history.force.size()) + 1);
    double largest = 0;
    for (const double force : history.force) {
        largest = std::max(largest, force);
        const double penetration = (largest - groups.gamma * (largest - force)) / (2 * groups.beta);
        const double x = penetration * units.penetration.factor;
        const double y = force * units.force.factor;
        if (std::isfinite(x) && std::isfinite(y))
            points.append(QCPCurveData(static_cast<double>(points.size()), x, y));
    }
    RockCurve curve{units, QSharedPointer<QCPCurveDataContainer>::create()};
    curve.path->set(points, true);
    return curve;
}

RockPlot::RockPlot(QCustomPlot* plot) : QObject(plot), m_plot(plot) {
    plot->axisRect()->setupFullAxesBox(true);
    plot->axisRect()->setMinimumMargins(QMargins(4, 4, 12, 4));
    m_curve = new QCPCurve(plot->xAxis, plot->yAxis);
    m_curve->setName(tr("impact force; the area is the energy left in the rock"));
    // Above the plot, where it can hide no part of the curve.
    plot->plotLayout()->insertRow(0);
    plot->plotLayout()->addElement(0, 0, plot->legend);
    plot->plotLayout()->setRowStretchFactor(0, 1e-3);
    plot->legend->setVisible(true);
}

void RockPlot::show(const RockCurve& curve) {
    m_curve->setData(curve.path);
    m_plot->xAxis->setLabel(curve.units.penetration.axisLabel(tr("penetration U")));
    m_plot->yAxis->setLabel(curve.units.force.axisLabel(tr("impact force F")));
    double right = 0;
    double top = 0;
    for (auto point = curve.path->constBegin(); point != curve.path->constEnd(); ++point) {
        right = std::max(right, point->key);
        top = std::max(top, point->value);
    }
    m_plot->xAxis->setRange(0, right > 0 ? 1.08 * right : 1);
    m_plot->yAxis->setRange(0, top > 0 ? 1.08 * top : 1);
}

void RockPlot::setStyle(const PlotStyle& style) {
    m_plot->setBackground(style.background);
    style.applyTo(*m_plot->axisRect());
    style.applyTo(*m_plot->legend);
    m_curve->setPen(style.linePen(0));
    m_curve->setBrush(style.areaBrush(0));
}

}  // namespace drillwave
