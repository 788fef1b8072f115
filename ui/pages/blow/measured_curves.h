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

/// A measured normal force is drawn with the waves, a measured impact force with the computed one; each has a
/// colour and a dash that no computed curve has. Lives as a child of the plots.
class MeasuredCurves : public QObject {
    Q_OBJECT

  public:
    explicit MeasuredCurves(BlowPlots* plots);

    /// Over the curves of a blow of a scenario in physical units, in the units of its plots.
    void present(const std::vector<MeasuredSignal>& measured, const Scenario& scenario,
                 const ShownUnits& units);
    void setStyle(const PlotStyle& style);
    /// One for each signal, in their order.
    const QVector<QCPGraph*>& graphs() const { return m_graphs; }

    static QPen pen(const PlotStyle& style, int index);

  private:
    /// Contents of a graph, so that points are rebuilt only when these change.
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

/// Whether a blow has times and forces that a measurement can be compared with: of physical units.
bool isComparable(const SolvedBlow& blow);

}  // namespace drillwave
