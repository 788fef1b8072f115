// SPDX-License-Identifier: GPL-3.0-or-later
// Plots of the window's pages as drawn in files: on white, with the words and units of a command or of the
// window.
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

/// Plot for a file, with its default size [mm]. Requires a QApplication (any platform).
struct PaperPlot {
    std::shared_ptr<QCustomPlot> plot;
    Millimetres size;
};

/// Language, number format and units of a plot in a file. The default is that of the command line: English, C
/// locale, SI.
struct PaperReader {
    UnitSystem system = UnitSystem::si;  ///< units for scenarios given in physical units
    /// Units chosen for individual kinds of quantity; they override `system`.
    ChosenUnits chosen = {};
    QLocale locale = QLocale::c();
    /// Whether the words of the plot are in the language set by speak(), instead of English.
    bool isSpokenTo = false;

    /// Returns the present language, number format and units of the window for plots in files. Returns a
    /// default object if they equal those of the command line.
    static PaperReader of(const UnitChoice& units);
    /// Returns true if language, number format and units are those of the command line: English, C locale,
    /// SI.
    bool isPlain() const;
    ShownUnits unitsFor(const Scenario& scenario) const;
    const Unit& unitFor(const Parameter& parameter) const;
};

/// Returns an empty plot for a file, with numbers in the given locale.
std::shared_ptr<QCustomPlot> emptyPaperPlot(const QLocale& locale = QLocale::c());

/// Returns a plot for a file, drawn by the class `Plot` that also draws a page of the window. `Plot` is a
/// child of a QCustomPlot with setStyle() and present().
template <class Plot, class Shown>
PaperPlot paperPlot(const Shown& shown, Millimetres size, const QLocale& locale = QLocale::c()) {
    PaperPlot paper{emptyPaperPlot(locale), size};
    auto* drawn = new Plot(paper.plot.get());
    drawn->setStyle(PlotStyle::forPaper());
    drawn->present(shown);
    return paper;
}

// The functions that take a Blow require it to be solved with its histories.

/// Returns the plot of waves, impact force, impulse and momentum over time. If the scenario has units, the
/// `measured` signals are drawn over the curves. The waves are shown at the position of the first signal
/// measured inside rod or string (see shareOnPaper()).
PaperPlot blowPaperPlot(const Blow& blow, const PaperReader& reader = {},
                        const std::vector<MeasuredSignal>& measured = {});
/// Returns the first signal that was measured inside the rod or string; nullptr if there is none.
const MeasuredSignal* firstInside(const std::vector<MeasuredSignal>& measured);
/// Returns the position x/L, 0 … 1, at which blowPaperPlot() shows the waves. It is that of the first signal
/// measured inside the rod or string. Without one it is the middle of the rod, or of the string's longest
/// section.
double shareOnPaper(const Scenario& scenario, const std::vector<MeasuredSignal>& measured);
/// Returns the plot of force on the rock over penetration.
PaperPlot rockPaperPlot(const Blow& blow, const PaperReader& reader = {});
/// Returns the plot of the largest stresses over the position in the rod or string. `stop` ends the
/// computation early.
PaperPlot rodPaperPlot(const Blow& blow, const std::stop_token& stop, const PaperReader& reader = {});
/// Returns the drawing of hammer and drill string to scale.
PaperPlot stringPaperPlot(const Scenario& scenario, const PaperReader& reader = {});
/// Returns the picture of the force in the rod or string over position and time.
PaperPlot wavePaperPlot(const Blow& blow, const PaperReader& reader = {});
/// Returns the plot of a figure that a study has computed. The mark `here` shows the point of the present
/// scenario.
PaperPlot figurePaperPlot(const StudyFigure& figure, const Scenario& scenario, const PaperReader& reader = {},
                          const std::optional<FigurePoint>& here = {});
/// Returns the plot of many blows in sequence; if there is nothing to show, a plot with the reason. If `stop`
/// is requested, the curve of e over the gap is missing.
PaperPlot drillingPaperPlot(const DrillingResult& result, const std::stop_token& stop,
                            const PaperReader& reader = {});
/// Returns the plot of a scan: results of many blows over the parameter that the scan varies.
PaperPlot scanPaperPlot(const DrillingScan& scan, const PaperReader& reader = {});
/// Returns the plot of the designs of a design study. Requires that the study has found a best design
/// (BestDesigns::robust).
PaperPlot designPaperPlot(const DesignReport& report, const PaperReader& reader = {});

}  // namespace drillwave
