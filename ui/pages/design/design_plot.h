// SPDX-License-Identifier: GPL-3.0-or-later
// A study of designs: the band of the first aim over the choice, the Pareto set, and what is worth measuring.
#pragma once

#include <memory>
#include <optional>

#include "ui/pages/design/design_map.h"
#include "ui/plot/study_frame.h"

namespace drillwave {

/// Above, the first aim over the last choice, in the band from its 5 % to its 95 % quantile, or over two
/// choices in colours; below, the second aim over the first, and the Sobol indices. The plot above is fitted
/// and zoomed.
class DesignPlot : public StudyFrame {
    Q_OBJECT

  public:
    explicit DesignPlot(QCustomPlot* plot);
    ~DesignPlot() override;

    /// Shows the picture; the view stays where it is unless it was fitted, or choice or units changed.
    void present(const DesignPicture& picture);
    const DesignPicture& picture() const { return m_picture; }
    /// The curves of the first aim, series by series.
    const QVector<QCPGraph*>& graphs() const { return m_aims; }
    /// All curves over the choice.
    QVector<QCPGraph*> curves() const;
    /// The value of a curve over words at the one nearest to x.
    static std::function<double(double x)> atWords(const QCPGraph& graph);
    /// Whether colours replace the curves.
    bool isMap() const { return m_picture.map.has_value(); }
    /// Describes a place of the map in words; empty elsewhere.
    QString mapWords(QPointF place) const;
    /// The design nearest to a click, in the coordinates of its rect; nothing where there is none near.
    std::optional<std::uint64_t> designAt(const QCPAxisRect* rect, QPointF coordinates) const;
    KeyPlaces keyPlaces() const override;
    /// Whether anything is shown below the first axes.
    bool hasRowBelow() const { return !m_picture.secondAim.isEmpty() || !m_picture.bars.isEmpty(); }
    /// Lines of text that the Sobol indices take, one of each number and one of each output.
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

/// Breaks a name into lines so that so many of them have room beside each other.
QString inLines(const QString& name, qsizetype count);

}  // namespace drillwave
