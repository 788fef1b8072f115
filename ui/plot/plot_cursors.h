// SPDX-License-Identifier: GPL-3.0-or-later
// Vertical lines across all curves of a plot: the cursors A and B, and the time cursor shared with other
// pages.
#pragma once

#include <qcustomplot.h>

#include <QPointF>
#include <QPointer>
#include <QVector>
#include <array>
#include <optional>

#include "ui/plot/plot_style.h"

namespace drillwave {

/// Cursor of a plot: A and B read curves, `time` marks the time that is shown on all pages.
enum class PlotCursor { a, b, time };

/// Vertical lines of the cursors A, B and time, through every axis rect that has graphs; these rects share
/// one x axis. The lines are on the layer "overlay", so that moving them redraws nothing else.
class PlotCursors {
  public:
    explicit PlotCursors(QCustomPlot& plot) : m_plot(plot) {}

    /// Places the cursor at x (unit of the axis), or removes it if x is empty or not finite. The caller
    /// redraws the plot.
    void place(PlotCursor cursor, std::optional<double> x);
    /// Returns the x of a cursor in the unit of the axis; nothing if it is not placed.
    std::optional<double> position(PlotCursor cursor) const { return of(cursor).x; }
    /// Returns the cursor within a few pixels of a point of the plot. If several are that close, A is
    /// preferred to B, and B to time.
    std::optional<PlotCursor> cursorAt(QPointF point) const;
    void setStyle(const PlotStyle& style);
    /// Returns the axis rects that have graphs, in the order in which the plot contains them (from top to
    /// bottom).
    QList<QCPAxisRect*> rects() const;

  private:
    struct Cursor {
        std::optional<double> x;
        QVector<QPointer<QCPItemStraightLine>> lines;
        QPointer<QCPItemText> label;
    };
    Cursor& of(PlotCursor cursor) { return m_cursors[static_cast<std::size_t>(cursor)]; }
    const Cursor& of(PlotCursor cursor) const { return m_cursors[static_cast<std::size_t>(cursor)]; }
    void addItems(PlotCursor cursor);
    void applyStyle(PlotCursor cursor);

    QCustomPlot& m_plot;
    std::array<Cursor, 3> m_cursors;
    PlotStyle m_style = PlotStyle::forPaper();
};

}  // namespace drillwave
