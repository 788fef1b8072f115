// SPDX-License-Identifier: GPL-3.0-or-later
// Figure of a sequence of blows and of a scan of sequences (drilling §7).
#pragma once

#include <stop_token>
#include <vector>

#include "core/report/figure.h"
#include "core/study/scan/drilling_scan.h"

namespace drillwave {

/// A sequence of blows, as far as it is solved.
struct ShownSequence {
    const Scenario& scenario;
    const DrillingSettings& settings;
    const std::vector<DrillingBlow>& blows;
    const DrillingResult* result = nullptr;  ///< once it is complete
    FigureSeries corOverGap = {};            ///< corOverPeriod()
    const ShownSequence* before = nullptr;   ///< shown faintly
};

struct ShownScan {
    const DrillingScan& scan;
    const DrillingScan* constantForce = nullptr;
    const DrillingScan* strongDamper = nullptr;
    bool isOld = false;  ///< of an earlier scenario, shown faintly
};

/// Panels of drillingFigure(); empty ones are hidden.
enum class DrillingPanel { rate, penetration, gap, scannedGap, phase, returns, energy };

/// Shows a sequence, a scan or both; without details only rates and penetrations.
StudyFigure drillingFigure(const ShownSequence* sequence, const ShownScan* scan, bool isDetailed = true);

/// Returns e of a single blow over the gap [d0], for one period of the gap; empty if there is no period.
FigureSeries corOverPeriod(const Scenario& scenario, const std::stop_token& stop);

}  // namespace drillwave
