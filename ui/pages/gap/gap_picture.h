// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn of a study of the gap.
#pragma once

#include <QPointF>
#include <QString>
#include <QVector>
#include <optional>

#include "core/report/gap_report.h"
#include "ui/pages/gap/gap_study.h"
#include "ui/pages/study/curve_marks.h"
#include "ui/plot/graph_data.h"

class QCPCurveData;

namespace drillwave {

/// An output over the gap, and beside it how its values are distributed. In the units of `gap` and `value`;
/// built away from the window's thread, never changed once built.
struct GapPicture {
    GapOutput output = GapOutput::cor;
    ShownUnit gap;    ///< of gaps: d0 or a length
    ShownUnit value;  ///< of the output
    double from = 0;  ///< gap at which the curve begins
    double to = 1;    ///< and at which its period ends
    GraphData curve;  ///< value over gap
    QVector<QPointF>
        shares;              ///< outline of the distribution: share of gaps [%] in each band of values, value
    QVector<QPointF> below;  ///< share of gaps [%] with at most that value, value
    QVector<CurveMark> marks;             ///< by gap
    GapSpread spread;                     ///< of the distribution that was asked for
    bool isScattered = false;             ///< that is normal, not of all gaps alike
    std::optional<double> shareAboveOne;  ///< of e
    std::optional<double> thrust;         ///< for 95 % of gaps, where there is one
    ShownUnit thrustUnit;                 ///< of it
};

/// Requires a complete curve with its statistics.
GapPicture gapPicture(const GapReport& report, GapOutput output, const ShownUnits& units);

/// A first look: blows at some gaps, ascending, and nothing that needs them all.
GapPicture gapPreview(const std::vector<GapSample>& samples, GapOutput output, const ShownUnits& units);

/// "COR e", "peak force Fm", "efficiency".
QString gapOutputName(GapOutput output);

}  // namespace drillwave
