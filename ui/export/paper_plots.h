// SPDX-License-Identifier: GPL-3.0-or-later
// The plots of the pages as they go into files: on white, text in the C locale, in naturalUnits().
#pragma once

#include <memory>
#include <stop_token>

#include "core/blow/blow.h"
#include "core/report/gap_report.h"
#include "core/report/thrust_report.h"
#include "ui/plot/plot_rendering.h"
#include "ui/plot/plot_style.h"

class QCustomPlot;

namespace drillwave {

/// A plot, and the size it has where nothing else is asked for. Requires a QApplication (any platform).
struct PaperPlot {
    std::shared_ptr<QCustomPlot> plot;
    Millimetres size;
};

/// An empty plot for paper.
std::shared_ptr<QCustomPlot> emptyPaperPlot();

/// By the plot of a page: a Plot is made as a child of a QCustomPlot, and has setStyle() and present(shown).
template <class Plot, class Shown>
PaperPlot paperPlot(const Shown& shown, Millimetres size) {
    PaperPlot paper{emptyPaperPlot(), size};
    auto* drawn = new Plot(paper.plot.get());
    drawn->setStyle(PlotStyle::forPaper());
    drawn->present(shown);
    return paper;
}

/// Of a rod or a string that has its histories.
PaperPlot blowPaperPlot(const Blow& blow);
PaperPlot rockPaperPlot(const Blow& blow);
/// Waves, impact force, impulse and momentum over time, of an impact solved with Detail::histories.
PaperPlot blowPaperPlot(const Scenario& scenario, const Impact& impact);
/// Force over penetration, likewise.
PaperPlot rockPaperPlot(const Scenario& scenario, const Impact& impact);
/// The largest stresses over place, likewise.
PaperPlot rodPaperPlot(const Scenario& scenario, const Impact& impact, const std::stop_token& stop);
/// The same of a rod or a string that has its histories.
PaperPlot rodPaperPlot(const Blow& blow, const std::stop_token& stop);
/// Hammer and string to scale.
PaperPlot stringPaperPlot(const Scenario& scenario);
/// The force in the rod over place and time, of a blow solved likewise.
PaperPlot wavePaperPlot(const Blow& blow);
/// e over the gap and its distribution.
PaperPlot gapPaperPlot(const GapReport& report);
/// The needs along a parameter, of a report that has them.
PaperPlot thrustPaperPlot(const ThrustReport& report);

}  // namespace drillwave
