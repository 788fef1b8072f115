// SPDX-License-Identifier: GPL-3.0-or-later
// A vertical line at a value of x that the user drags with the mouse.
#pragma once

#include <qcustomplot.h>

#include <QObject>
#include <QString>
#include <optional>

#include "ui/plot/plot_style.h"

namespace drillwave {

/// Vertical line with a name that the user can drag. Dragging that starts on the line does not pan the plot.
/// The plot owns the object.
class DragLine : public QObject {
    Q_OBJECT

  public:
    /// Creates the line over the whole height of `rect`, an axis rect of `plot`. The line is hidden at first.
    DragLine(QCustomPlot& plot, QCPAxisRect* rect);

    /// Shows the line at x (unit of the axis) with the label `name`. During a drag the line stays at the
    /// mouse pointer instead, but jumps to `snap` when it is within a few pixels.
    void present(const QString& name, double x, std::optional<double> snap);
    void hide();
    /// Returns the present x of the line, in the unit of the axis.
    double x() const { return m_x; }
    void setStyle(const PlotStyle& style);

  signals:
    /// Reports that the user is dragging the line, which is now at x (unit of the axis).
    void moved(double x);
    /// Reports that the user has released the line at x (unit of the axis).
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
    bool m_hasHand = false;  // whether the pointer has the shape for dragging
};

}  // namespace drillwave
