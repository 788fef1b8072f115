// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/report_plots.h"

#include <qcustomplot.h>

namespace drillwave {
namespace {

/// As much of a page of A4 as it can have together with the others.
ReportPlot placed(const char* name, const char* caption, PaperPlot paper, Millimetres size) {
    paper.size = size;
    return {{name, caption, name}, std::move(paper)};
}

}  // namespace

std::vector<ReportPlot> reportPlots(const BlowReport& report, const std::stop_token& stop) {
    const Blow& blow = report.blow;
    std::vector<ReportPlot> plots;
    // On paper the first one fills the page of the words, the next two a page, the others the last one.
    plots.push_back(placed("rock", "Force over penetration: the area inside stays in the rock as energy.",
                           rockPaperPlot(blow.scenario, blow.impact), {120, 66}));
    plots.push_back(
        placed("blow",
               "The force N at the middle of the rod and its waves, the impact force, its impulse "
               "and the momentum of the rod over time.",
               blowPaperPlot(blow.scenario, blow.impact), {180, 128}));
    plots.push_back(placed("wave_picture",
                           "The force in the rod over place and time, tension positive; bars at the right "
                           "show the contact of bit and rock. On the scale of colours a line is the least or "
                           "largest force, a triangle one beyond the colours.",
                           wavePaperPlot(blow), {180, 86}));
    plots.push_back(placed("rod",
                           "The largest tension and compression along the rod, while the blow lasts and of "
                           "the waves left.",
                           rodPaperPlot(blow.scenario, blow.impact, stop), {180, 84}));
    if (report.gap)
        plots.push_back(placed("gap",
                               "Restitution over one period of the gap between bit and rock, and how it is "
                               "distributed when all gaps are alike.",
                               gapPaperPlot(*report.gap), {180, 72}));
    if (report.thrust && report.thrust->along)
        plots.push_back(placed("thrust", "Needs of the thrust and the installed one over the blow frequency.",
                               thrustPaperPlot(*report.thrust), {180, 68}));
    return plots;
}

}  // namespace drillwave
