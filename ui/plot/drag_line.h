// SPDX-License-Identifier: GPL-3.0-or-later
// A line at a value of x that the mouse moves.
#pragma once

#include <qcustomplot.h>

#include <QObject>
#include <QString>
#include <optional>

#include "ui/plot/plot_style.h"

namespace drillwave {

/// Dragging the line takes the place of panning there. Lives as a child of the plot.
class DragLine : public QObject {
    Q_OBJECT

  public:
    /// Through all of `rect`, a rect of the plot.
    DragLine(QCustomPlot& plot, QCPAxisRect* rect);

    /// Shows the line, in coordinates of the axes; while it is in the hand it stays where that is. The line
    /// jumps to `snap` within a few pixels.
    void present(const QString& name, double x, std::optional<double> snap);
    void hide();
    double x() const { return m_x; }
    void setStyle(const PlotStyle& style);

  signals:
    /// The line is in the hand and has been moved there.
    void moved(double x);
    /// It has been let go there.
    void released(double x);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    double pixelOf(double x) const { return m_rect->axis(QCPAxis::atBottom)->coordToPixel(x); }
    bool isNear(QPointF pixel) const;
    void moveTo(double pixel);
    void place();
    void showHand(bool isNear);

    QCustomPlot& m_plot;
    QCPAxisRect* m_rect;
    QCPItemStraightLine* m_line;
    QCPItemText* m_name;
    double m_x = 0;
    std::optional<double> m_snap;
    bool m_isDragged = false;
    bool m_hasHand = false;  // shown at the pointer
};

}  // namespace drillwave
