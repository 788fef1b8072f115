// SPDX-License-Identifier: GPL-3.0-or-later
// The plots of the pages as they go into files: on white, for the reader of a command or of a window.
#pragma once

#include <QLocale>
#include <memory>
#include <stop_token>

#include "core/blow/blow.h"
#include "core/report/design_report.h"
#include "core/report/figure.h"
#include "core/signal/alignment.h"
#include "core/study/drilling/drilling_study.h"
#include "core/study/scan/drilling_scan.h"
#include "ui/plot/plot_rendering.h"
#include "ui/plot/plot_style.h"
#include "ui/text/shown_units.h"

class QCustomPlot;

namespace drillwave {

class UnitChoice;

/// A plot and its default size. Requires a QApplication (any platform).
struct PaperPlot {
    std::shared_ptr<QCustomPlot> plot;
    Millimetres size;
};

/// Words, numbers and units of a paper: by default those of the commands, English, the C locale and SI.
struct PaperReader {
    UnitSystem system = UnitSystem::si;  ///< of scenarios that have units
    ChosenUnits chosen = {};             ///< of kinds that do not follow it
    QLocale locale = QLocale::c();
    bool isSpokenTo = false;  ///< in the language that the program speaks, which is another than English

    /// Returns the window's present reader; that of the commands if words, numbers and units are the same.
    static PaperReader of(const UnitChoice& units);
    /// Whether that is the reader of the commands.
    bool isPlain() const;
    ShownUnits unitsFor(const Scenario& scenario) const;
    const Unit& unitFor(const Parameter& parameter) const;
};

/// An empty plot for paper.
std::shared_ptr<QCustomPlot> emptyPaperPlot(const QLocale& locale = QLocale::c());

/// Makes a paper plot by the plot class of a page: a child of a QCustomPlot with setStyle() and present().
template <class Plot, class Shown>
PaperPlot paperPlot(const Shown& shown, Millimetres size, const QLocale& locale = QLocale::c()) {
    PaperPlot paper{emptyPaperPlot(locale), size};
    auto* drawn = new Plot(paper.plot.get());
    drawn->setStyle(PlotStyle::forPaper());
    drawn->present(shown);
    return paper;
}

// These require a blow with its histories.

/// Waves, impact force, impulse and momentum over time; signals are laid over them, of a scenario with units.
/// The waves are those of the section of the first signal that is one of inside.
PaperPlot blowPaperPlot(const Blow& blow, const PaperReader& reader = {},
                        const std::vector<MeasuredSignal>& measured = {});
/// Returns the first signal measured inside; nullptr if there is none.
const MeasuredSignal* firstInside(const std::vector<MeasuredSignal>& measured);
/// x/L of that section.
double shareOnPaper(const Scenario& scenario, const std::vector<MeasuredSignal>& measured);
/// Force over penetration.
PaperPlot rockPaperPlot(const Blow& blow, const PaperReader& reader = {});
/// The largest stresses over place.
PaperPlot rodPaperPlot(const Blow& blow, const std::stop_token& stop, const PaperReader& reader = {});
/// Hammer and string to scale.
PaperPlot stringPaperPlot(const Scenario& scenario, const PaperReader& reader = {});
/// The force in the rod over place and time.
PaperPlot wavePaperPlot(const Blow& blow, const PaperReader& reader = {});
/// A figure about a scenario.
PaperPlot figurePaperPlot(const StudyFigure& figure, const Scenario& scenario,
                          const PaperReader& reader = {});
/// Many blows, or why there is nothing to show. A stop leaves out a curve.
PaperPlot drillingPaperPlot(const DrillingResult& result, const std::stop_token& stop,
                            const PaperReader& reader = {});
/// The scan of a parameter.
PaperPlot scanPaperPlot(const DrillingScan& scan, const PaperReader& reader = {});
/// The designs of a study that has a robust best.
PaperPlot designPaperPlot(const DesignReport& report, const PaperReader& reader = {});

}  // namespace drillwave
