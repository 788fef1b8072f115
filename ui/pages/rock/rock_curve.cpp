// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/rock/rock_curve.h"

#include <qcustomplot.h>

#include <QVector>
#include <algorithm>
#include <cmath>

#include "core/contact/contact_law.h"
#include "core/wave/field/wave_curves.h"
#include "core/wave/field/wave_field.h"

namespace drillwave {
namespace {

RockCurve::Path pathOf(const Blow& blow, const ShownUnits& units) {
    const Impact& impact = blow.impact;
    if (!impact.hasHistories()) return RockCurve::Path::create();
    const SampledHistory history = sampleHistory(impact);
    QVector<QCPCurveData> points{QCPCurveData(impact.frontArrival * units.time.factor, 0, 0)};
    points.reserve(static_cast<qsizetype>(history.force.size()) + 1);
    ContactLaw<> rock(blow.problem.law);
    if (blow.marched) rock.rememberAcross(blow.marched->rememberedForce);
    for (std::size_t i = 0; i < history.force.size(); ++i) {
        const double force = history.force[i];
        rock.rememberAcross(force);
        const double penetration = rock.penetration(force) * lawUnitOfPenetration;
        const double x = penetration * units.penetration.factor;
        const double y = force * units.force.factor;
        if (std::isfinite(x) && std::isfinite(y))
            points.append(QCPCurveData(history.time[i] * units.time.factor, x, y));
    }
    auto path = QSharedPointer<QCPCurveDataContainer>::create();
    path->set(points, true);
    return path;
}

// Simplifies the path: a blow of a million reflections runs up and down its lines a million times, and takes
// minutes to fill. Unloading lines too close to be seen apart are reduced to the deepest.
RockCurve::Path outlineOf(const QSharedPointer<QCPCurveDataContainer>& path, double peakForce) {
    constexpr int pointsDrawnAtOnce = 20000;
    constexpr double linesTold = 4000;
    if (path->size() <= pointsDrawnAtOnce) return path;
    QVector<QCPCurveData> points;
    const auto append = [&points](const QCPCurveData& point) {
        points.append(QCPCurveData(static_cast<double>(points.size()), point.key, point.value));
    };
    QCPCurveData peak = *path->constBegin();
    QCPCurveData lowest = peak;
    double lineBegin = peak.value;
    append(peak);
    for (auto point = path->constBegin(); point != path->constEnd(); ++point) {
        if (point->value > lineBegin + peakForce / linesTold) {
            append(peak);
            append(lowest);
            append(peak);
            peak = lowest = *point;
            lineBegin = peak.value;
        } else if (point->value > peak.value) {
            peak = *point;
        } else if (point->value <= lowest.value) {
            lowest = *point;
        }
    }
    append(peak);
    append(lowest);
    append(*(path->constEnd() - 1));
    auto outline = QSharedPointer<QCPCurveDataContainer>::create();
    outline->set(points, true);
    return outline;
}

/// Returns the lines up to the largest force.
QVector<RockLine> linesOf(const BitRockLaw& law, double peakForce, const ShownUnits& units) {
    QVector<RockLine> lines;
    ContactLaw<> rock(law);
    double slope = law.firstSlope;
    const auto here = [&] {
        return QPointF(rock.largestPenetration() * lawUnitOfPenetration * units.penetration.factor,
                       rock.largestForce() * units.force.factor);
    };
    for (std::size_t next = 0;; ++next) {
        RockLine line{.from = here(), .to = {}, .slope = slope};
        const bool goesOn = rock.hasCorner() && rock.cornerForce() < peakForce;
        rock.remember(goesOn ? rock.cornerForce() : peakForce);
        line.to = here();
        lines.append(line);
        if (!goesOn) return lines;
        rock.passCorner();
        slope = law.corners[next].slope;
    }
}

}  // namespace

RockCurve rockCurve(const Blow& blow, const ShownUnits& units) {
    const ImpactSummary& summary = blow.summary;
    const BitRockLaw& law = blow.problem.law;
    const double peakForce = summary.peakForce * units.force.factor;
    const auto path = pathOf(blow, units);
    const auto slopes = ContactLaw<>(law).slopes();
    return {.units = units,
            .path = path,
            .outline = outlineOf(path, peakForce),
            .peakForce = peakForce,
            .maxPenetration = summary.maxPenetration * units.penetration.factor,
            .residualPenetration = summary.residualPenetration * units.penetration.factor,
            .loading = slopes.primary * units.stiffness.factor,
            .unloading = slopes.elastic * units.stiffness.factor,
            .lines = linesOf(law, summary.peakForce, units),
            .energy = summary.energy.rockWork * blow.drivenEnergy() * units.energy.factor,
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
