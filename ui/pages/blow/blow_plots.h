// SPDX-License-Identifier: GPL-3.0-or-later
// The four plots of a blow on one time axis: the same drawing code for the page and for files.
#pragma once

#include <QLocale>
#include <array>

#include "ui/pages/blow/blow_curves.h"
#include "ui/plot/study_frame.h"

namespace drillwave {

/// Lays four axis rects with linked time axes into a plot and fills them: fitted, all curves are in view.
class BlowPlots : public StudyFrame {
    Q_OBJECT

  public:
    static constexpr int plotCount = 4;

    explicit BlowPlots(QCustomPlot* plot);

    /// Shows the curves; the view stays where it is unless it was fitted or the units changed.
    void present(const BlowCurves& curves);
    /// Shows the curves of another blow faintly, in no legend; nullptr removes them.
    void setGhost(const BlowCurves* before);
    /// A curve of something else among those of a kind, in its legend; it is fitted with them. The caller
    /// gives it data and pen, and takes it away again.
    enum class Kind { waves, impactForce };
    QCPGraph* addOverlay(Kind kind, const QString& name);
    void removeOverlay(QCPGraph* overlay);
    /// Describes the place of these waves in a drill string.
    static QString placeText(const BlowCurves& curves, const QLocale& locale);
    /// Names curves and axes.
    void name();
    QCPAxisRect* axisRect(int index) const { return m_plots.at(static_cast<std::size_t>(index)).rect; }
    /// N at the section, the sum of all waves there.
    QCPGraph* sectionForceGraph() const { return m_plots[0].graphs.first(); }
    /// The waves N0p, N1n, N2p, N3n.
    QCPGraph* waveGraph(int number) const { return m_plots[0].graphs[1 + number]; }
    /// Graph of all later waves towards the bit (0) or from it (1), in the legend only if there are any.
    QCPGraph* laterGraph(int heading) const { return m_plots[0].graphs[1 + BlowCurves::waveCount + heading]; }
    QCPGraph* forceGraph() const { return m_plots[1].graphs.first(); }
    /// In its legend only while the closed form holds.
    QCPGraph* closedFormGraph() const { return m_plots[1].graphs[1]; }
    /// The hammer's force on a drill string.
    QCPGraph* faceForceGraph() const { return m_plots[1].graphs[2]; }
    /// Graphs of the pinned runs, in the legend of the force.
    const QVector<QCPGraph*>& sumsOfRuns() const { return m_plots[0].runs->graphs(); }
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
    /// In a legend only while it has data, as it cannot be hidden or shown otherwise.
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
