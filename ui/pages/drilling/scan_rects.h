// SPDX-License-Identifier: GPL-3.0-or-later
// The plots of a scan of many blows: penetration rate with its error band and contact share, and the gaps.
#pragma once

#include <qcustomplot.h>

#include "ui/pages/drilling/drilling_picture.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

/// Axis rects and curves of a scan. The parent frame owns them; it fits the plot and places rates() and
/// gaps() in the layout.
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
    /// Returns the texts at the lines of notable feed forces, such as "f I₀".
    QStringList marks() const;

    /// Shows a scan. With `isOld` it is drawn faintly, because it belongs to an earlier scenario.
    void present(const ScanPicture& picture, const DrillingShown& units, bool isOld);
    void setStyle(const PlotStyle& style);
    void fit();
    /// Places the texts at the lines so that they do not overlap. Call this after the layout of the plot.
    void placeMarks();
    /// Returns the distance of the text of a mark from the top of its axis rect [px].
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
