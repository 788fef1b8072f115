#include "ui/plots/rock_curve.h"

#include <QVector>
#include <algorithm>
#include <cmath>

#include "core/study/impact_summary.h"
#include "core/wave/wave_field.h"

namespace drillwave {
namespace {

QSharedPointer<QCPCurveDataContainer> pathOf(const Impact& impact, const Groups& groups,
                                             const ShownUnits& units) {
    const SampledHistory history = sampleHistory(impact);
    QVector<QCPCurveData> points{QCPCurveData(impact.frontArrival * units.time.factor, 0, 0)};
    points.reserve(static_cast<qsizetype>(history.force.size()) + 1);
    double largest = 0;
    for (std::size_t i = 0; i < history.force.size(); ++i) {
        const double force = history.force[i];
        largest = std::max(largest, force);
        const double penetration = (largest - groups.gamma * (largest - force)) / (2 * groups.beta);
        const double x = penetration * units.penetration.factor;
        const double y = force * units.force.factor;
        if (std::isfinite(x) && std::isfinite(y))
            points.append(QCPCurveData(history.time[i] * units.time.factor, x, y));
    }
    auto path = QSharedPointer<QCPCurveDataContainer>::create();
    path->set(points, true);
    return path;
}

}  // namespace

RockCurve rockCurve(const Impact& impact, const Groups& groups, const ShownUnits& units) {
    const ImpactSummary summary = summarize(impact, groups);
    return {.units = units,
            .path = pathOf(impact, groups, units),
            .peakForce = summary.peakForce * units.force.factor,
            .maxPenetration = summary.maxPenetration * units.penetration.factor,
            .residualPenetration = summary.residualPenetration * units.penetration.factor,
            .loading = groups.beta * units.stiffness.factor,
            .unloading = groups.beta / groups.gamma * units.stiffness.factor,
            .energy = summary.energy.rockWork * summary.workRatio * units.energy.factor,
            .energyShare = summary.energy.rockWork};
}

QPointF rockPoint(const RockCurve& curve, double time) {
    const QCPCurveDataContainer& path = *curve.path;
    if (path.isEmpty()) return {};
    const auto behind = std::upper_bound(path.constBegin(), path.constEnd(), time,
                                         [](double t, const QCPCurveData& point) { return t < point.t; });
    if (behind == path.constBegin()) return {behind->key, behind->value};
    const auto before = behind - 1;
    if (behind == path.constEnd()) return {before->key, before->value};
    const double share = (time - before->t) / (behind->t - before->t);
    return {before->key + share * (behind->key - before->key),
            before->value + share * (behind->value - before->value)};
}

}  // namespace drillwave
