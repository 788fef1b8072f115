// SPDX-License-Identifier: GPL-3.0-or-later
// "You are here": the mark of the present scenario on the plot of a study.
#pragma once

#include <qcustomplot.h>

#include <QObject>
#include <optional>

#include "ui/plot/plot_style.h"

namespace drillwave {

/// Mark at the values of the present scenario (the current input): a ring on a vertical line. It is on the
/// overlay layer, so that it follows the input without a full replot. The plot owns it; it is hidden at
/// first.
class HereMark : public QObject {
    Q_OBJECT

  public:
    HereMark(QCustomPlot* plot, QCPAxis* x, QCPAxis* y);

    /// Moves the mark to x and y, in the units of the axes. Without y only the line is shown, without x
    /// nothing. Replots the overlay layer if the place has changed.
    virtual void setPlace(std::optional<double> x, std::optional<double> y);
    virtual void setStyle(const PlotStyle& style);
    /// Returns the x of the mark, in the unit of the axis; nothing while the mark is hidden.
    std::optional<double> x() const { return m_x; }
    /// Returns the y of the mark, in the unit of the axis. Nothing if the mark is only a vertical line, or
    /// hidden.
    std::optional<double> y() const { return m_y; }
    /// Returns x and y of the mark of the present scenario, in the units of the axes. Nothing if the mark is
    /// hidden or has only an x.
    std::optional<QPointF> place() const {
        return m_x && m_y ? std::optional(QPointF(*m_x, *m_y)) : std::nullopt;
    }

  protected:
    QCPItemTracer* ring() const { return m_ring; }

  private:
    std::optional<double> m_x;
    std::optional<double> m_y;
    QCPItemStraightLine* m_line;
    QCPItemTracer* m_ring;
};

}  // namespace drillwave
