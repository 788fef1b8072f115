// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/report_plots.h"

#include <qcustomplot.h>

namespace drillwave {
namespace {

/// As much of a page of A4 as its plots can have together with the others.
ReportPlot placed(const char* name, const char* caption, PaperPlot paper, Millimetres size) {
    constexpr double wide = 100;
    paper.size = size;
    return {{name, caption, name, size.width > wide}, std::move(paper)};
}

}  // namespace

std::vector<ReportPlot> reportPlots(const BlowReport& report) {
    const Blow& blow = report.blow;
    std::vector<ReportPlot> plots;
    plots.push_back(placed("blow",
                           "The waves at the middle of the rod, the impact force, its impulse and the "
                           "momentum of the rod over time.",
                           blowPaperPlot(blow.scenario, blow.impact), {180, 130}));
    plots.push_back(placed("wave_picture",
                           "The force in the rod over place and time, tension positive; bars at the right "
                           "show the contact of bit and rock.",
                           wavePaperPlot(blow), {180, 88}));
    plots.push_back(placed("rock", "Force over penetration: the area inside stays in the rock as energy.",
                           rockPaperPlot(blow.scenario, blow.impact), {120, 70}));
    if (report.gap)
        plots.push_back(placed("gap",
                               "Restitution over one period of the gap between bit and rock, and how it is "
                               "distributed when all gaps are alike.",
                               gapPaperPlot(*report.gap), {180, 76}));
    if (report.thrust && report.thrust->along)
        plots.push_back(placed("thrust", "Needs of the thrust and the installed one over the blow frequency.",
                               thrustPaperPlot(*report.thrust), {180, 72}));
    return plots;
}

}  // namespace drillwave
