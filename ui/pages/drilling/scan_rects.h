// SPDX-License-Identifier: GPL-3.0-or-later
// The rects of a scan of many blows: penetration rate with its band and the contact share, and the gaps.
#pragma once

#include <qcustomplot.h>

#include "ui/pages/drilling/drilling_picture.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

/// Lives as a child of the frame that fits the plot and places rates() and gaps().
class ScanRects : public QObject {
    Q_OBJECT

  public:
    ScanRects(QCustomPlot& plot, QCPLegend& legend, QObject* parent);

    QCPAxisRect* rates() const { return m_rates; }
    QCPAxisRect* gaps() const { return m_gaps; }
    QCPGraph* rate() const { return m_rate; }
    QCPGraph* contactShare() const { return m_share; }
    QCPGraph* gapDots() const { return m_dots; }
    QCPGraph* constantForce() const { return m_constantForce; }
    QCPGraph* strongDamper() const { return m_strongDamper; }
    /// "f I₀", …, as they stand at their lines.
    QStringList marks() const;

    /// `isOld`: of an earlier scenario, faintly.
    void present(const ScanPicture& picture, const DrillingShown& units, bool isOld);
    void setStyle(const PlotStyle& style);
    void fit();
    /// So that their words can be read; once the plot is laid out.
    void placeMarks();
    /// Where the words of a mark are, from the top of the rect [px].
    double markTop(int index) const {
        return m_marks[index].words->position->pixelPosition().y() - m_rates->top();
    }

  private:
    QCPGraph* add(QCPAxisRect* rect, QCPAxis* values, const QString& name, bool hasPoints);
    void list(QCPGraph* graph, bool isListed);
    void showMarks(const ScanPicture& picture);

    QCustomPlot& m_plot;
    QCPLegend& m_legend;
    QCPAxisRect *m_rates, *m_gaps;
    QCPGraph *m_low, *m_high, *m_rate, *m_other, *m_share, *m_constantForce, *m_strongDamper, *m_dots,
        *m_otherDots;
    struct Mark {
        QCPItemStraightLine* line;
        QCPItemText* words;
    };
    QVector<Mark> m_marks;
    double m_from = 0, m_to = 1;
    bool m_isOld = false;
};

}  // namespace drillwave
