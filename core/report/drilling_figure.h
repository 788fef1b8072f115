// SPDX-License-Identifier: GPL-3.0-or-later
// Figure of a sequence of blows and of a scan of sequences (drilling §7).
#pragma once

#include <stop_token>
#include <vector>

#include "core/report/figure.h"
#include "core/study/scan/drilling_scan.h"

namespace drillwave {

/// Sequence of blows for the figure; `blows` holds the blows computed so far.
struct ShownSequence {
    const Scenario& scenario;
    const DrillingSettings& settings;
    const std::vector<DrillingBlow>& blows;
    const DrillingResult* result = nullptr;  ///< result of the complete sequence; nullptr until then
    FigureSeries corOverGap = {};            ///< curve of corOverPeriod() for the scenario; may be empty
    /// Sequence of an earlier scenario to draw faintly; nullptr for none.
    const ShownSequence* before = nullptr;
};

struct ShownScan {
    const DrillingScan& scan;
    const DrillingScan* constantForce = nullptr;
    const DrillingScan* strongDamper = nullptr;
    /// Whether the scan belongs to an earlier scenario, so that the figure asks for a new scan.
    bool isOld = false;
};

/// Indices of the panels of drillingFigure(). Panels without data are hidden. `phase` shows how gap/d0 is
/// distributed between whole numbers, `returns` each gap over the one before.
enum class DrillingPanel { rate, penetration, gap, scannedGap, phase, returns, energy };

/// Returns the figure of a sequence of blows, of a scan of sequences, or of both; nullptr omits one of them.
/// If `isDetailed` is false, it has only penetration rates and penetrations.
StudyFigure drillingFigure(const ShownSequence* sequence, const ShownScan* scan, bool isDetailed = true);

/// Returns the coefficient of restitution e of a single blow over the gap [d0], for one period of the gap.
/// Empty if results are not periodic in the gap.
FigureSeries corOverPeriod(const Scenario& scenario, const std::stop_token& stop);

}  // namespace drillwave
