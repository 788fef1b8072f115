// SPDX-License-Identifier: GPL-3.0-or-later
// Vertical lines over all curves of a plot: the cursors A and B, and the time shared with other pages.
#pragma once

#include <qcustomplot.h>

#include <QPointF>
#include <QPointer>
#include <QVector>
#include <array>
#include <optional>

#include "ui/plot/plot_style.h"

namespace drillwave {

enum class PlotCursor { a, b, time };

/// Lines through every axis rect that has graphs, which share one x axis, on the layer "overlay": moving them
/// redraws nothing else.
class PlotCursors {
  public:
    explicit PlotCursors(QCustomPlot& plot) : m_plot(plot) {}

    /// Puts a cursor to x, or takes it away; replots nothing.
    void place(PlotCursor cursor, std::optional<double> x);
    std::optional<double> position(PlotCursor cursor) const { return of(cursor).x; }
    /// The cursor within a few pixels of a point of the plot, A and B before the time.
    std::optional<PlotCursor> cursorAt(QPointF point) const;
    void setStyle(const PlotStyle& style);
    /// The axis rects with graphs, from the top.
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
