// SPDX-License-Identifier: GPL-3.0-or-later
// A place of a plot between lines across its axes, read in words.
#pragma once

#include <qcustomplot.h>

#include <QPointer>
#include <array>

#include "ui/plot/hover_mark.h"

namespace drillwave {

/// A ring with lines through it, thin on a pale ground so that they are seen on any colour, and a label.
/// Redraws only its layer "overlay".
class CrossMark {
  public:
    explicit CrossMark(QCustomPlot& plot) : m_plot(plot), m_mark(plot) {}

    /// Shows it at a place in the coordinates of the bottom and left axes of `rect`, always the same rect.
    void show(QCPAxisRect& rect, QPointF place, const QString& text);
    void hide();
    void setStyle(const PlotStyle& style);
    /// The label, empty while it is hidden.
    QString text() const { return m_mark.text(); }

  private:
    void addLines(QCPAxisRect& rect);
    void redraw();

    QCustomPlot& m_plot;
    HoverMark m_mark;
    std::array<QPointer<QCPItemTracer>, 2> m_lines;  // the ground first
    PlotStyle m_style = PlotStyle::forPaper();
};

}  // namespace drillwave
