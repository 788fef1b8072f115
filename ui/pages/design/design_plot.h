// SPDX-License-Identifier: GPL-3.0-or-later
// The plots of a design study: first objective over the design variable, Pareto set and Sobol indices.
#pragma once

#include <memory>
#include <optional>

#include "ui/pages/design/design_map.h"
#include "ui/plot/study_frame.h"

namespace drillwave {

/// Plots of a design study. The upper plot shows the first objective over the last design variable, with a
/// band between the quantiles of 5 % and 95 %. For two design variables it can be a map. The lower plots show
/// the second objective over the first, and the Sobol indices. Only the upper plot is fitted and zoomed.
class DesignPlot : public StudyFrame {
    Q_OBJECT

  public:
    explicit DesignPlot(QCustomPlot* plot);
    ~DesignPlot() override;

    /// Shows the data. The present zoom is kept, unless the view was fitted, or design variable or units
    /// changed.
    void present(const DesignPicture& picture);
    const DesignPicture& picture() const { return m_picture; }
    /// Returns the curves of the first objective, one for each combination of the other design variables.
    const QVector<QCPGraph*>& graphs() const { return m_aims; }
    /// Returns all curves over the design variable.
    QVector<QCPGraph*> curves() const;
    /// Returns the function y(x) of a curve whose x are words: its value at the word nearest to x, or NaN.
    static std::function<double(double x)> atWords(const QCPGraph& graph);
    /// Returns whether a coloured map is shown instead of curves.
    bool isMap() const { return m_picture.map.has_value(); }
    /// Returns a description of a place of the map; empty without a map or outside it.
    QString mapWords(QPointF place) const;
    /// Returns the index of the design nearest to a click at `coordinates` of `rect`; nothing if none is
    /// near.
    std::optional<std::uint64_t> designAt(const QCPAxisRect* rect, QPointF coordinates) const;
    KeyPlaces keyPlaces() const override;
    /// Returns whether plots are shown below the upper plot.
    bool hasRowBelow() const { return !m_picture.secondAim.isEmpty() || !m_picture.bars.isEmpty(); }
    /// Returns the height of the plot of Sobol indices in lines of text: one for each input and one for each
    /// output.
    int barLines() const;

  private:
    void clear() override;
    void restyle() override;
    void setRanges() override;
    void addRects();
    void makeGraphs();
    void fillLegend();
    void nameAxes();
    void showMarks();
    void showScatter();
    void showBars();

    DesignPicture m_picture;
    std::unique_ptr<DesignMap> m_map;
    QVector<QCPGraph*> m_aims;
    QCPGraph *m_low, *m_high, *m_mean, *m_nominal;
    QCPGraph *m_robustMark, *m_nominalMark, *m_ties, *m_presentMark;
    QCPLayoutGrid* m_below;
    QCPAxisRect *m_scatterRect, *m_barRect;
    QCPGraph *m_all, *m_pareto, *m_best;
    struct BarPair {
        QCPBars *total, *first;
    };
    QVector<BarPair> m_bars;
    QVector<QCPItemText*> m_barNames;
};

/// Returns a name broken into lines, so that `count` names fit side by side below an axis.
QString inLines(const QString& name, qsizetype count);

}  // namespace drillwave
