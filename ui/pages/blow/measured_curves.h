// SPDX-License-Identifier: GPL-3.0-or-later
// Measured signals laid over the curves of a blow.
#pragma once

#include <QObject>
#include <QVector>
#include <vector>

#include "core/signal/alignment.h"
#include "ui/job/solved_blow.h"
#include "ui/pages/blow/blow_plots.h"

namespace drillwave {

/// Measured signals over the curves of a blow. A measured normal force is drawn with the waves, a measured
/// impact force with the computed one. Each has a colour and dashes that no computed curve has. The plots own
/// the object.
class MeasuredCurves : public QObject {
    Q_OBJECT

  public:
    explicit MeasuredCurves(BlowPlots* plots);

    /// Draws the measured signals in the units of the plots. Requires a scenario in physical units.
    void present(const std::vector<MeasuredSignal>& measured, const Scenario& scenario,
                 const ShownUnits& units);
    void setStyle(const PlotStyle& style);
    /// Returns the graphs of the measured signals, in the order of the signals.
    const QVector<QCPGraph*>& graphs() const { return m_graphs; }

    /// Returns the pen of measured signal `index` (from 0). The first four differ in colour and dashes.
    static QPen pen(const PlotStyle& style, int index);

  private:
    /// Contents of a graph; its points are rebuilt only if these change.
    struct Shown {
        MeasuredSignal signal;
        double timeFactor = 0;
        double forceFactor = 0;
    };
    void match(const std::vector<MeasuredSignal>& measured);

    BlowPlots* m_plots;
    PlotStyle m_style;
    QVector<QCPGraph*> m_graphs;
    std::vector<Shown> m_shown;
};

/// Returns whether a blow can be compared with measurements: its scenario has physical units and it was
/// computed without error.
bool isComparable(const SolvedBlow& blow);

}  // namespace drillwave
