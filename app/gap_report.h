// SPDX-License-Identifier: GPL-3.0-or-later
// The statistics over the gap as the gap command tells them.
#pragma once

#include <QByteArray>
#include <optional>
#include <string>

#include "core/model/scenario.h"
#include "core/study/gap/gap_statistics.h"
#include "core/study/rows/output_column.h"

namespace drillwave {

/// All that is reported.
struct GapReport {
    Scenario scenario;
    GapCurve curve;
    std::optional<NormalGap> normal;
    GapStatistics statistics;
    double runTime = 0;        ///< [s]
    std::string scenarioText;  ///< gives the same scenario again

    /// What the reader should know about the period, empty when it begins at no gap.
    std::string periodRemark() const;
};

/// A table for people, forces and gaps in the units of a dimensional scenario.
std::string gapText(const GapReport& report);

/// One JSON object, dimensionless, with the scales that lead to SI.
QByteArray gapJson(const GapReport& report);

/// The curve: gap and all outputs, kinks included. SI needs a dimensional scenario.
std::string gapCsv(const GapReport& report, OutputUnits units);

}  // namespace drillwave
