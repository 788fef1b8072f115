// SPDX-License-Identifier: GPL-3.0-or-later
// The four plots of a blow on one time axis; the same code draws the page and files.
#pragma once

#include <QLocale>
#include <array>

#include "ui/pages/blow/blow_curves.h"
#include "ui/plot/study_frame.h"

namespace drillwave {

/// Four plots of a blow, one above the other, with linked time axes. Zoom to fit shows all curves.
class BlowPlots : public StudyFrame {
    Q_OBJECT

  public:
    static constexpr int plotCount = 4;

    explicit BlowPlots(QCustomPlot* plot);

    /// Shows the curves of a blow. A zoom by the user is kept if the units are the same; otherwise all curves
    /// are brought into view.
    void present(const BlowCurves& curves);
    /// Shows the curves of an earlier blow faintly, for comparison, without legend entries; nullptr removes
    /// them.
    void setGhost(const BlowCurves* before);
    /// Plot to which addOverlay() adds a curve.
    enum class Kind { waves, impactForce };
    /// Adds a curve, such as a measured signal, to the plot of this kind and to its legend. Zoom to fit
    /// includes it. Returns the curve, for which the caller sets data and pen. See removeOverlay().
    QCPGraph* addOverlay(Kind kind, const QString& name);
    /// Removes a curve that addOverlay() has returned from its plot.
    void removeOverlay(QCPGraph* overlay);
    /// Returns a text for the place in a drill string where the waves are observed.
    static QString placeText(const BlowCurves& curves, const QLocale& locale);
    /// Sets the names of curves and axes in the present language.
    void name();
    /// Returns the number of rows of all legends together; a legend without entries counts as one row.
    int legendRows() const;
    QCPAxisRect* axisRect(int index) const { return m_plots.at(static_cast<std::size_t>(index)).rect; }
    /// Returns the graph of the normal force N at the observed position of the rod, which is the sum of all
    /// waves there.
    QCPGraph* sectionForceGraph() const { return m_plots[0].graphs.first(); }
    /// Returns the graph of wave `number` (0 … 3): N0p, N1n, N2p, N3n. Waves p run towards the bit, waves n
    /// from it.
    QCPGraph* waveGraph(int number) const { return m_plots[0].graphs[1 + number]; }
    /// Returns the graph of the sum of all waves after N3n, towards the bit (`heading` 0) or from it (1). It
    /// has a legend entry only if such waves exist.
    QCPGraph* laterGraph(int heading) const { return m_plots[0].graphs[1 + BlowCurves::waveCount + heading]; }
    QCPGraph* forceGraph() const { return m_plots[1].graphs.first(); }
    /// Returns the graph of the impact force from the closed form (analytical solution). It has a legend
    /// entry only if the closed form is valid.
    QCPGraph* closedFormGraph() const { return m_plots[1].graphs[1]; }
    /// Returns the graph of the force between hammer and drill string.
    QCPGraph* faceForceGraph() const { return m_plots[1].graphs[2]; }
    /// Returns the graphs of the normal force N at the observed position, one for each pinned run (result
    /// kept for comparison).
    const QVector<QCPGraph*>& sumsOfRuns() const { return m_plots[0].runs->graphs(); }
    /// Returns the graphs of the impact force, one for each pinned run (result kept for comparison).
    const QVector<QCPGraph*>& forcesOfRuns() const { return m_plots[1].runs->graphs(); }
    QCPGraph* impulseGraph() const { return m_plots[2].graphs.first(); }
    QCPGraph* momentumGraph() const { return m_plots[3].graphs.first(); }

  private:
    struct Plot {
        QCPAxisRect* rect = nullptr;
        QCPTextElement* title = nullptr;
        QCPLegend* legend = nullptr;
        QVector<QCPGraph*> graphs;
        QVector<QCPGraph*> ghosts;
        QVector<QCPGraph*> overlays;
        RunGraphs* runs = nullptr;
    };
    void clear() override;
    void restyle() override;
    void setRanges() override;
    static QStringList namesOf(std::size_t plot);
    void addPlot(std::size_t index, QCPMarginGroup* margins);
    void wrapLegends();
    void linkTimeAxes();
    void showClosedForm();
    void nameWaves();
    void summarizeString();
    /// Sets the data of a graph of plot `index`. The graph has a legend entry only while it has data, or
    /// always if `always`.
    void showWhereThere(std::size_t index, QCPGraph& graph, const GraphData& data, bool always = false);
    void showRuns();
    void addGhost(std::size_t index, int kind, const GraphData& data);
    void setLabels();
    void summarize();

    std::array<Plot, plotCount> m_plots;
    BlowCurves m_curves;
    double m_timeEnd = 1;
    double m_ghostEnd = 0;
    double m_runsEnd = 0;
};

}  // namespace drillwave
