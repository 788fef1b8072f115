// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/gap/run_gaps.h"

#include <qcustomplot.h>

#include "core/wave/problem.h"

namespace drillwave {
namespace {

constexpr int mostPeriods = 20;  // drawn: of a run with a small blow there could be thousands

}  // namespace

std::optional<GapCurve> runGap(const Scenario& scenario, const std::stop_token& stop) {
    GapCurve curve = gapCurve(problemOf(scenario), Detail::events, stop);
    if (!curve.isComplete()) return std::nullopt;
    return curve;
}

GraphData runGapCurve(const GapCurve& curve, GapOutput output, double gapFactor, double valueFactor,
                      double to) {
    QVector<QCPGraphData> points;
    const std::vector<double> gaps = sampleGaps(curve);
    const auto append = [&](double gap, double shift) {
        const double x = (gap + shift) * gapFactor;
        if (x <= to) appendFinite(points, x, curve.value(output, gap) * valueFactor);
        return x <= to;
    };
    bool isInside = true;
    for (const double gap : gaps)
        if (isInside) isInside = append(gap, 0);
    const bool hasPeriod = curve.dependsOnGap && curve.end > curve.periodStart;
    for (int period = 1; isInside && hasPeriod && period < mostPeriods; ++period)
        for (const double gap : gaps)
            if (isInside && gap >= curve.periodStart) isInside = append(gap, period);
    return graphData(points);
}

}  // namespace drillwave
