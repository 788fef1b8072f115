// SPDX-License-Identifier: GPL-3.0-or-later
// A cross with a label, which marks one place of a plot.
#pragma once

#include <qcustomplot.h>

#include <QPointer>
#include <array>

#include "ui/plot/hover_mark.h"

namespace drillwave {

/// Ring with two thin lines through it and a label, which marks the keyboard point of a plot. A pale band
/// below the lines makes them visible on any colour. Changes redraw only the layer "overlay".
class CrossMark {
  public:
    explicit CrossMark(QCustomPlot& plot) : m_plot(plot), m_mark(plot) {}

    /// Shows the cross at the point `place`, given in the coordinates of the bottom and left axes of `rect`,
    /// with the label `text`. Every call for the same cross must pass the same `rect`.
    void show(QCPAxisRect& rect, QPointF place, const QString& text);
    void hide();
    void setStyle(const PlotStyle& style);
    /// Returns the label of the cross; empty while the cross is hidden.
    QString text() const { return m_mark.text(); }

  private:
    void addLines(QCPAxisRect& rect);
    void redraw();

    QCustomPlot& m_plot;
    HoverMark m_mark;
    std::array<QPointer<QCPItemTracer>, 2> m_lines;  // the pale band first, then the lines
    PlotStyle m_style = PlotStyle::forPaper();
};

}  // namespace drillwave
