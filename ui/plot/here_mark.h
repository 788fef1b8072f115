// SPDX-License-Identifier: GPL-3.0-or-later
// "You are here": where on a plot of a study the present scenario is.
#pragma once

#include <qcustomplot.h>

#include <QObject>
#include <optional>

#include "ui/plot/plot_style.h"

namespace drillwave {

/// A ring on a line through it, on the overlay layer, so that it follows the hand without a full replot.
/// Lives as a child of the plot; hidden at first.
class HereMark : public QObject {
    Q_OBJECT

  public:
    HereMark(QCustomPlot* plot, QCPAxis* x, QCPAxis* y);

    /// Moves it, in units of the axes; without a y only the line is shown, without an x nothing. Replots only
    /// the overlay layer, and only after a change.
    void setPlace(std::optional<double> x, std::optional<double> y);
    void setStyle(const PlotStyle& style);
    std::optional<double> x() const { return m_x; }
    std::optional<double> y() const { return m_y; }
    /// Both coordinates; nothing if one is missing.
    std::optional<QPointF> place() const {
        return m_x && m_y ? std::optional(QPointF(*m_x, *m_y)) : std::nullopt;
    }

  private:
    std::optional<double> m_x;
    std::optional<double> m_y;
    QCPItemStraightLine* m_line;
    QCPItemTracer* m_ring;
};

}  // namespace drillwave
