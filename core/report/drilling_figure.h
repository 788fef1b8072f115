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
    /// Sequence of blows of an earlier scenario, drawn faintly for comparison; nullptr for none.
    const ShownSequence* before = nullptr;
};

struct ShownScan {
    const DrillingScan& scan;
    const DrillingScan* constantForce = nullptr;
    const DrillingScan* strongDamper = nullptr;
    /// Whether the scan belongs to an earlier scenario. It is then drawn faintly, and the caption asks the
    /// user to scan again.
    bool isOld = false;
};

/// Indices of the panels of drillingFigure(); panels without data are hidden. `phase` is a histogram of the
/// gap modulo d0, which determines e. `returns` shows each gap on the x axis and the gap at the next blow on
/// the y axis.
enum class DrillingPanel { rate, penetration, gap, scannedGap, phase, returns, energy };

/// Returns the figure of a sequence of blows, of a scan of sequences, or of both. nullptr omits the sequence
/// or the scan. If `isDetailed` is false, the figure has only penetration rates and penetrations.
StudyFigure drillingFigure(const ShownSequence* sequence, const ShownScan* scan, bool isDetailed = true);

/// Returns the coefficient of restitution e of a single blow as a curve over one period of the gap [d0].
/// Empty if results are not periodic in the gap.
FigureSeries corOverPeriod(const Scenario& scenario, const std::stop_token& stop);

}  // namespace drillwave
